<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- English: only what depends on a number. The rest is the text of the sources. -->
<TS version="2.1" language="en">
<context>
    <name>glint::ExportDialog</name>
    <message numerus="yes">
        <source> · %n picture(s): %1 …</source>
        <translation>
            <numerusform> · %n picture: %1 …</numerusform>
            <numerusform> · %n pictures: %1 …</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glint::FileController</name>
    <message numerus="yes">
        <source>Open without %n bad part(s)</source>
        <translation>
            <numerusform>Open without the bad part</numerusform>
            <numerusform>Open without %n bad parts</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glint::MainWindow</name>
    <message numerus="yes">
        <source>%n selected</source>
        <translation>
            <numerusform>%n selected</numerusform>
            <numerusform>%n selected</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glint::MaterialModel</name>
    <message numerus="yes">
        <source>%1: %2, %n object(s)
Drag it onto an object</source>
        <translation>
            <numerusform>%1: %2, %n object
Drag it onto an object</numerusform>
            <numerusform>%1: %2, %n objects
Drag it onto an object</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glint::StatusLine</name>
    <message numerus="yes">
        <source>%n faulty sample(s)</source>
        <translation>
            <numerusform>%n faulty sample</numerusform>
            <numerusform>%n faulty samples</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation>
            <numerusform>%n warning</numerusform>
            <numerusform>%n warnings</numerusform>
        </translation>
    </message>
</context>
</TS>
