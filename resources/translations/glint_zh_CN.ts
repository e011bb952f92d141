<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN">
<context>
    <name>CommandBindings</name>
    <message>
        <source>&amp;Undo %1</source>
        <translation>撤销 %1(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>重做 %1(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>About Glint</source>
        <translation>关于 Glint</translation>
    </message>
    <message>
        <source>Glint %1
A scene editor whose viewport is a ray tracer.
MIT licence.</source>
        <translation>Glint %1
以光线追踪为视图的场景编辑器。
MIT 许可证。</translation>
    </message>
</context>
<context>
    <name>EditGestures</name>
    <message>
        <source>Select</source>
        <translation>选择</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>缩放</translation>
    </message>
</context>
<context>
    <name>ExportPanel</name>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 分 %2 秒</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 小时 %2 分</translation>
    </message>
    <message>
        <source>frame %1 of %2</source>
        <translation>第 %1 帧，共 %2 帧</translation>
    </message>
    <message>
        <source>%1 spp</source>
        <translation>%1 采样</translation>
    </message>
    <message>
        <source>± %1 %</source>
        <translation>± %1 %</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>剩余 %1</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>等待中</translation>
    </message>
    <message>
        <source>starting</source>
        <translation>正在启动</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>已暂停</translation>
    </message>
    <message>
        <source>done</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>canceled</source>
        <translation>已取消</translation>
    </message>
</context>
<context>
    <name>Field</name>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>  by texture</source>
        <translation>  由纹理</translation>
    </message>
    <message>
        <source>name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>球体</translation>
    </message>
    <message>
        <source>box</source>
        <translation>盒体</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>quad</source>
        <translation>矩形面</translation>
    </message>
    <message>
        <source>disk</source>
        <translation>圆盘</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>圆柱</translation>
    </message>
    <message>
        <source>cone</source>
        <translation>圆锥</translation>
    </message>
    <message>
        <source>torus</source>
        <translation>圆环</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>major_radius</source>
        <translation>主半径</translation>
    </message>
    <message>
        <source>minor_radius</source>
        <translation>管半径</translation>
    </message>
    <message>
        <source>file</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>part</source>
        <translation>部件</translation>
    </message>
    <message>
        <source>material</source>
        <translation>材质</translation>
    </message>
    <message>
        <source>emission</source>
        <translation>发光</translation>
    </message>
    <message>
        <source>two_sided</source>
        <translation>双面</translation>
    </message>
    <message>
        <source>transform</source>
        <translation>变换</translation>
    </message>
    <message>
        <source>translate</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>rotate_degrees</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>matrix</source>
        <translation>矩阵</translation>
    </message>
    <message>
        <source>parent</source>
        <translation>父组</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>可见</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>锁定</translation>
    </message>
    <message>
        <source>light_group</source>
        <translation>灯光组</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>up</source>
        <translation>上方向</translation>
    </message>
    <message>
        <source>projection</source>
        <translation>投影</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>透视</translation>
    </message>
    <message>
        <source>orthographic</source>
        <translation>正交</translation>
    </message>
    <message>
        <source>vertical_fov_degrees</source>
        <translation>垂直视角</translation>
    </message>
    <message>
        <source>ortho_height</source>
        <translation>正交高度</translation>
    </message>
    <message>
        <source>aperture_radius</source>
        <translation>光圈半径</translation>
    </message>
    <message>
        <source>focus_distance</source>
        <translation>对焦距离</translation>
    </message>
    <message>
        <source>type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>image</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>checker</source>
        <translation>棋盘格</translation>
    </message>
    <message>
        <source>gradient</source>
        <translation>渐变</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>噪波</translation>
    </message>
    <message>
        <source>color_space</source>
        <translation>色彩空间</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>srgb</source>
        <translation>sRGB</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>线性</translation>
    </message>
    <message>
        <source>mapping</source>
        <translation>映射</translation>
    </message>
    <message>
        <source>uv</source>
        <translation>UV</translation>
    </message>
    <message>
        <source>triplanar</source>
        <translation>三平面</translation>
    </message>
    <message>
        <source>colors</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>filter</source>
        <translation>滤波器</translation>
    </message>
    <message>
        <source>tent</source>
        <translation>三角</translation>
    </message>
    <message>
        <source>blackman_harris</source>
        <translation>布莱克曼-哈里斯</translation>
    </message>
    <message>
        <source>filter_radius</source>
        <translation>滤波半径</translation>
    </message>
    <message>
        <source>exposure_ev</source>
        <translation>曝光</translation>
    </message>
    <message>
        <source>view</source>
        <translation>视图变换</translation>
    </message>
    <message>
        <source>standard</source>
        <translation>标准</translation>
    </message>
    <message>
        <source>integrator</source>
        <translation>积分器</translation>
    </message>
    <message>
        <source>path</source>
        <translation>路径追踪</translation>
    </message>
    <message>
        <source>classic</source>
        <translation>经典</translation>
    </message>
    <message>
        <source>max_depth</source>
        <translation>最大深度</translation>
    </message>
    <message>
        <source>spp</source>
        <translation>每像素采样</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>time_seconds</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>error_percent</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>clamp</source>
        <translation>钳制</translation>
    </message>
    <message>
        <source>transparent_shadows</source>
        <translation>透明阴影</translation>
    </message>
    <message>
        <source>color</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>sky</source>
        <translation>天空</translation>
    </message>
    <message>
        <source>sun_direction</source>
        <translation>太阳方向</translation>
    </message>
    <message>
        <source>turbidity</source>
        <translation>浑浊度</translation>
    </message>
    <message>
        <source>intensity</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>rotation_degrees</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>visible_to_camera</source>
        <translation>相机可见</translation>
    </message>
    <message>
        <source>diffuse</source>
        <translation>漫反射</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>镜面</translation>
    </message>
    <message>
        <source>metal</source>
        <translation>金属</translation>
    </message>
    <message>
        <source>glass</source>
        <translation>玻璃</translation>
    </message>
    <message>
        <source>translucent</source>
        <translation>半透明</translation>
    </message>
    <message>
        <source>glossy</source>
        <translation>光泽</translation>
    </message>
    <message>
        <source>phong</source>
        <translation>Phong</translation>
    </message>
    <message>
        <source>mix</source>
        <translation>混合</translation>
    </message>
    <message>
        <source>roughness</source>
        <translation>粗糙度</translation>
    </message>
    <message>
        <source>ior</source>
        <translation>折射率</translation>
    </message>
    <message>
        <source>absorption</source>
        <translation>吸收</translation>
    </message>
    <message>
        <source>thin</source>
        <translation>薄片</translation>
    </message>
    <message>
        <source>priority</source>
        <translation>优先级</translation>
    </message>
    <message>
        <source>reflectance</source>
        <translation>反射率</translation>
    </message>
    <message>
        <source>transmittance</source>
        <translation>透射率</translation>
    </message>
    <message>
        <source>specular</source>
        <translation>高光</translation>
    </message>
    <message>
        <source>exponent</source>
        <translation>指数</translation>
    </message>
    <message>
        <source>reflection</source>
        <translation>反射</translation>
    </message>
    <message>
        <source>refraction</source>
        <translation>折射</translation>
    </message>
    <message>
        <source>a</source>
        <translation>A</translation>
    </message>
    <message>
        <source>b</source>
        <translation>B</translation>
    </message>
    <message>
        <source>amount</source>
        <translation>混合量</translation>
    </message>
    <message>
        <source>point</source>
        <translation>点光</translation>
    </message>
    <message>
        <source>spot</source>
        <translation>聚光</translation>
    </message>
    <message>
        <source>sun</source>
        <translation>太阳光</translation>
    </message>
    <message>
        <source>cone_degrees</source>
        <translation>锥角</translation>
    </message>
    <message>
        <source>blend</source>
        <translation>边缘过渡</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>irradiance</source>
        <translation>辐照度</translation>
    </message>
    <message>
        <source>angle_degrees</source>
        <translation>角直径</translation>
    </message>
</context>
<context>
    <name>FieldBinding</name>
    <message>
        <source>Change %1</source>
        <translation>修改%1</translation>
    </message>
</context>
<context>
    <name>FieldDoc</name>
    <message>
        <source>Unique name</source>
        <translation>唯一的名称</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>外形</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Lengths along x, y and z</source>
        <translation>沿 x、y、z 的长度</translation>
    </message>
    <message>
        <source>Lengths along x and z</source>
        <translation>沿 x 和 z 的长度</translation>
    </message>
    <message>
        <source>Length along y</source>
        <translation>沿 y 的长度</translation>
    </message>
    <message>
        <source>Radius of the base</source>
        <translation>底面半径</translation>
    </message>
    <message>
        <source>From the centre to the middle of the tube</source>
        <translation>从中心到管中线的距离</translation>
    </message>
    <message>
        <source>Radius of the tube; from the major radius on, the tube closes the hole</source>
        <translation>管的半径；达到主半径时孔闭合</translation>
    </message>
    <message>
        <source>Model file, relative to the scene</source>
        <translation>模型文件，相对于场景</translation>
    </message>
    <message>
        <source>Name of one part of the file; empty for all</source>
        <translation>文件中某个部件的名称；留空表示全部</translation>
    </message>
    <message>
        <source>What it is made of; black if none</source>
        <translation>所用材质；没有则为黑色</translation>
    </message>
    <message>
        <source>Radiance of the outward side</source>
        <translation>外侧的辐亮度</translation>
    </message>
    <message>
        <source>Both sides emit</source>
        <translation>两面都发光</translation>
    </message>
    <message>
        <source>Place, turn and scale within the group</source>
        <translation>在组内的位置、旋转和缩放</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Turn about x, then y, then z</source>
        <translation>依次绕 x、y、z 旋转</translation>
    </message>
    <message>
        <source>Factor along each axis, before the turn; not 0</source>
        <translation>旋转之前沿各轴的系数；不能为 0</translation>
    </message>
    <message>
        <source>Row-major 3 x 4 matrix instead of the three above</source>
        <translation>代替以上三项的行优先 3 × 4 矩阵</translation>
    </message>
    <message>
        <source>Group that holds it</source>
        <translation>所属的组</translation>
    </message>
    <message>
        <source>Part of the picture</source>
        <translation>出现在画面中</translation>
    </message>
    <message>
        <source>Cannot be picked in the viewport</source>
        <translation>在视图中不能被选取</translation>
    </message>
    <message>
        <source>Group of lights it belongs to</source>
        <translation>所属的灯光组</translation>
    </message>
    <message>
        <source>Place, turn and scale of all it holds</source>
        <translation>其中全部对象的位置、旋转和缩放</translation>
    </message>
    <message>
        <source>Place of the eye</source>
        <translation>视点的位置</translation>
    </message>
    <message>
        <source>Point in the middle of the picture</source>
        <translation>画面中心对应的点</translation>
    </message>
    <message>
        <source>Direction that is up in the picture</source>
        <translation>画面中朝上的方向</translation>
    </message>
    <message>
        <source>With or without perspective</source>
        <translation>有无透视</translation>
    </message>
    <message>
        <source>Angle of view over the full height; below 180</source>
        <translation>整个高度上的视角；小于 180</translation>
    </message>
    <message>
        <source>Height of the picture without perspective</source>
        <translation>无透视时画面的高度</translation>
    </message>
    <message>
        <source>Radius of the lens; 0 is sharp everywhere</source>
        <translation>镜头半径；0 表示处处清晰</translation>
    </message>
    <message>
        <source>Along the view axis; the target if not given</source>
        <translation>沿视轴的距离；未给出则为目标点</translation>
    </message>
    <message>
        <source>Kind of texture</source>
        <translation>纹理的种类</translation>
    </message>
    <message>
        <source>Image file, relative to the scene</source>
        <translation>图像文件，相对于场景</translation>
    </message>
    <message>
        <source>How the file&apos;s numbers are meant</source>
        <translation>文件数值的含义</translation>
    </message>
    <message>
        <source>How it lies on the surface</source>
        <translation>在表面上的铺设方式</translation>
    </message>
    <message>
        <source>Repetitions along u and v</source>
        <translation>沿 u 和 v 的重复次数</translation>
    </message>
    <message>
        <source>Colours of a checker, gradient or noise</source>
        <translation>棋盘格、渐变或噪波的颜色</translation>
    </message>
    <message>
        <source>Width of the picture</source>
        <translation>画面宽度</translation>
    </message>
    <message>
        <source>Height of the picture</source>
        <translation>画面高度</translation>
    </message>
    <message>
        <source>Weight of samples within a pixel</source>
        <translation>像素内采样的权重</translation>
    </message>
    <message>
        <source>Half width of the filter</source>
        <translation>滤波器的半宽</translation>
    </message>
    <message>
        <source>Each step doubles the brightness</source>
        <translation>每级亮度加倍</translation>
    </message>
    <message>
        <source>From linear light to the screen</source>
        <translation>从线性光到屏幕</translation>
    </message>
    <message>
        <source>path: physically right; classic: the recursive algorithm of the report</source>
        <translation>路径追踪：物理正确；经典：报告中的递归算法</translation>
    </message>
    <message>
        <source>Most surface interactions on a path; light seen directly is 0</source>
        <translation>一条路径上最多的表面作用次数；直接看到的光为 0</translation>
    </message>
    <message>
        <source>Samples a pixel to stop at</source>
        <translation>达到此每像素采样数时停止</translation>
    </message>
    <message>
        <source>Other seeds give other noise</source>
        <translation>不同的种子给出不同的噪点</translation>
    </message>
    <message>
        <source>Time to stop at; 0 is no limit</source>
        <translation>达到此时间时停止；0 表示不限</translation>
    </message>
    <message>
        <source>Error of the picture to stop at, as a share of its mean brightness; 0 is no limit</source>
        <translation>达到此误差时停止，以平均亮度的比例计；0 表示不限</translation>
    </message>
    <message>
        <source>Largest sample value, biased; 0 is off</source>
        <translation>采样值上限，会有偏差；0 表示关闭</translation>
    </message>
    <message>
        <source>classic: glass tints shadows instead of blocking light</source>
        <translation>经典：玻璃给阴影着色而不挡光</translation>
    </message>
    <message>
        <source>Colour of the sky, or factor on the image</source>
        <translation>天空的颜色，或图像的系数</translation>
    </message>
    <message>
        <source>Latitude-longitude picture, relative to the scene</source>
        <translation>经纬图，相对于场景</translation>
    </message>
    <message>
        <source>Computed sky</source>
        <translation>计算天空</translation>
    </message>
    <message>
        <source>Towards the sun</source>
        <translation>指向太阳</translation>
    </message>
    <message>
        <source>Haze: 2 clear, 10 hazy</source>
        <translation>大气浑浊：2 晴朗，10 雾霾</translation>
    </message>
    <message>
        <source>Factor on the brightness</source>
        <translation>亮度系数</translation>
    </message>
    <message>
        <source>Turn about the upward axis</source>
        <translation>绕竖直轴旋转</translation>
    </message>
    <message>
        <source>Seen behind the objects; light and reflections stay</source>
        <translation>在物体后面可见；光照和反射不受影响</translation>
    </message>
    <message>
        <source>Share of light reflected</source>
        <translation>反射光的比例</translation>
    </message>
    <message>
        <source>Reflectance at normal incidence</source>
        <translation>垂直入射时的反射率</translation>
    </message>
    <message>
        <source>0 polished, 1 matt; alpha is its square</source>
        <translation>0 抛光，1 哑光；alpha 是它的平方</translation>
    </message>
    <message>
        <source>Refractive index</source>
        <translation>折射率</translation>
    </message>
    <message>
        <source>Inside, light fades by exp(-absorption * distance)</source>
        <translation>内部的光按 exp(-吸收 × 距离) 衰减</translation>
    </message>
    <message>
        <source>A sheet: no offset and no absorption</source>
        <translation>薄片：无偏移、无吸收</translation>
    </message>
    <message>
        <source>Where dielectrics overlap, the higher one fills</source>
        <translation>电介质重叠处由优先级高者填充</translation>
    </message>
    <message>
        <source>Share sent back to the lit side</source>
        <translation>返回受光面的比例</translation>
    </message>
    <message>
        <source>Share sent to the other side; with the reflectance at most 1</source>
        <translation>透到另一面的比例；与反射率之和至多为 1</translation>
    </message>
    <message>
        <source>Colour of the base under the coat</source>
        <translation>涂层下基底的颜色</translation>
    </message>
    <message>
        <source>Refractive index of the coat</source>
        <translation>涂层的折射率</translation>
    </message>
    <message>
        <source>Tints the diffuse and the mirror part</source>
        <translation>给漫反射和镜面部分着色</translation>
    </message>
    <message>
        <source>Share of Lambert&apos;s reflection</source>
        <translation>朗伯反射的比例</translation>
    </message>
    <message>
        <source>Share of the highlight</source>
        <translation>高光的比例</translation>
    </message>
    <message>
        <source>Sharpness of the highlight</source>
        <translation>高光的锐度</translation>
    </message>
    <message>
        <source>Share of the mirror ray</source>
        <translation>镜面光线的比例</translation>
    </message>
    <message>
        <source>Share of the refracted ray</source>
        <translation>折射光线的比例</translation>
    </message>
    <message>
        <source>Refractive index of the inside</source>
        <translation>内部的折射率</translation>
    </message>
    <message>
        <source>Material at amount 0, or clear</source>
        <translation>混合量为 0 时的材质，或透明</translation>
    </message>
    <message>
        <source>Material at amount 1, or clear</source>
        <translation>混合量为 1 时的材质，或透明</translation>
    </message>
    <message>
        <source>0 is all a, 1 is all b</source>
        <translation>0 全为 A，1 全为 B</translation>
    </message>
    <message>
        <source>Radiant intensity</source>
        <translation>辐射强度</translation>
    </message>
    <message>
        <source>Point that the axis goes through</source>
        <translation>光轴经过的点</translation>
    </message>
    <message>
        <source>Radiant intensity on the axis</source>
        <translation>光轴上的辐射强度</translation>
    </message>
    <message>
        <source>Full angle of the cone</source>
        <translation>锥体的全角</translation>
    </message>
    <message>
        <source>Share of the half angle over which the rim fades</source>
        <translation>边缘渐隐所占半角的比例</translation>
    </message>
    <message>
        <source>Direction in which the light travels</source>
        <translation>光传播的方向</translation>
    </message>
    <message>
        <source>On a plane that faces the sun</source>
        <translation>在正对太阳的平面上</translation>
    </message>
    <message>
        <source>Full angle of the disc; 0 is a single direction without a disc</source>
        <translation>日盘的全角；0 表示没有日盘的单一方向</translation>
    </message>
</context>
<context>
    <name>FieldEditor</name>
    <message>
        <source>Add a colour</source>
        <translation>添加颜色</translation>
    </message>
    <message>
        <source>Remove the last colour</source>
        <translation>移除最后一个颜色</translation>
    </message>
    <message>
        <source>None (black)</source>
        <translation>无（黑色）</translation>
    </message>
    <message>
        <source>New material</source>
        <translation>新材质</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>No texture</source>
        <translation>无纹理</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>透明</translation>
    </message>
</context>
<context>
    <name>FormBuilder</name>
    <message>
        <source>Unit: %1</source>
        <translation>单位：%1</translation>
    </message>
    <message>
        <source>Takes %1</source>
        <translation>可填%1</translation>
    </message>
    <message>
        <source>Set it, or leave it to the default</source>
        <translation>设定，或保持默认</translation>
    </message>
    <message>
        <source>Reset to the default</source>
        <translation>恢复默认值</translation>
    </message>
</context>
<context>
    <name>ItemForms</name>
    <message>
        <source>A name must not be empty</source>
        <translation>名称不能为空</translation>
    </message>
    <message>
        <source>Another one has this name</source>
        <translation>已有同名的</translation>
    </message>
    <message>
        <source>This one has no name of its own</source>
        <translation>它没有自己的名称</translation>
    </message>
    <message>
        <source>Material type</source>
        <translation>材质类型</translation>
    </message>
    <message>
        <source>Change material type</source>
        <translation>更改材质类型</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>Transform</source>
        <translation>变换</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>组</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>灯光</translation>
    </message>
    <message>
        <source>Emission</source>
        <translation>发光</translation>
    </message>
    <message>
        <source>Light type</source>
        <translation>灯光类型</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材质</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>纹理</translation>
    </message>
</context>
<context>
    <name>Language</name>
    <message>
        <source>As the system</source>
        <translation>跟随系统</translation>
    </message>
</context>
<context>
    <name>MaterialPreset</name>
    <message>
        <source>Gold</source>
        <translation>金</translation>
    </message>
    <message>
        <source>Metals</source>
        <translation>金属</translation>
    </message>
    <message>
        <source>Silver</source>
        <translation>银</translation>
    </message>
    <message>
        <source>Copper</source>
        <translation>铜</translation>
    </message>
    <message>
        <source>Aluminium</source>
        <translation>铝</translation>
    </message>
    <message>
        <source>Brushed aluminium</source>
        <translation>拉丝铝</translation>
    </message>
    <message>
        <source>Chromium</source>
        <translation>铬</translation>
    </message>
    <message>
        <source>Iron</source>
        <translation>铁</translation>
    </message>
    <message>
        <source>Nickel</source>
        <translation>镍</translation>
    </message>
    <message>
        <source>Titanium</source>
        <translation>钛</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>镜面</translation>
    </message>
    <message>
        <source>Glass</source>
        <translation>玻璃</translation>
    </message>
    <message>
        <source>Glass and gems</source>
        <translation>玻璃与宝石</translation>
    </message>
    <message>
        <source>Window pane</source>
        <translation>窗玻璃</translation>
    </message>
    <message>
        <source>Frosted glass</source>
        <translation>磨砂玻璃</translation>
    </message>
    <message>
        <source>Fused silica</source>
        <translation>石英玻璃</translation>
    </message>
    <message>
        <source>Acrylic</source>
        <translation>亚克力</translation>
    </message>
    <message>
        <source>Diamond</source>
        <translation>钻石</translation>
    </message>
    <message>
        <source>Sapphire</source>
        <translation>蓝宝石</translation>
    </message>
    <message>
        <source>Bottle glass</source>
        <translation>瓶玻璃</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>水</translation>
    </message>
    <message>
        <source>Liquids</source>
        <translation>液体</translation>
    </message>
    <message>
        <source>Milk</source>
        <translation>牛奶</translation>
    </message>
    <message>
        <source>Skimmed milk</source>
        <translation>脱脂牛奶</translation>
    </message>
    <message>
        <source>Cream</source>
        <translation>奶油</translation>
    </message>
    <message>
        <source>Marble</source>
        <translation>大理石</translation>
    </message>
    <message>
        <source>Stone and earth</source>
        <translation>石与土</translation>
    </message>
    <message>
        <source>Chalk</source>
        <translation>白垩</translation>
    </message>
    <message>
        <source>Terracotta</source>
        <translation>赤陶</translation>
    </message>
    <message>
        <source>Jade</source>
        <translation>玉</translation>
    </message>
    <message>
        <source>Wax</source>
        <translation>蜡</translation>
    </message>
    <message>
        <source>Car paint red</source>
        <translation>红色车漆</translation>
    </message>
    <message>
        <source>Paint and plastic</source>
        <translation>漆与塑料</translation>
    </message>
    <message>
        <source>Car paint blue</source>
        <translation>蓝色车漆</translation>
    </message>
    <message>
        <source>Plastic yellow</source>
        <translation>黄色塑料</translation>
    </message>
    <message>
        <source>Plastic green</source>
        <translation>绿色塑料</translation>
    </message>
    <message>
        <source>Porcelain</source>
        <translation>瓷</translation>
    </message>
    <message>
        <source>Rubber</source>
        <translation>橡胶</translation>
    </message>
    <message>
        <source>Matt grey paint</source>
        <translation>哑光灰漆</translation>
    </message>
</context>
<context>
    <name>NavigationGestures</name>
    <message>
        <source>Fly: W A S D, Q E · %1 m/s (wheel)</source>
        <translation>飞行：W A S D、Q E · %1 m/s（滚轮）</translation>
    </message>
    <message>
        <source>Rotate environment</source>
        <translation>旋转环境</translation>
    </message>
    <message>
        <source>Environment %1°</source>
        <translation>环境 %1°</translation>
    </message>
</context>
<context>
    <name>RegionGesture</name>
    <message>
        <source>Region %1 × %2 px</source>
        <translation>区域 %1 × %2 像素</translation>
    </message>
</context>
<context>
    <name>SceneTitle</name>
    <message>
        <source>Studio</source>
        <translation>影棚</translation>
    </message>
    <message>
        <source>Outdoor</source>
        <translation>室外</translation>
    </message>
    <message>
        <source>Room</source>
        <translation>房间</translation>
    </message>
    <message>
        <source>Picture light</source>
        <translation>图像照明</translation>
    </message>
    <message>
        <source>Empty</source>
        <translation>空场景</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>立柱</translation>
    </message>
    <message>
        <source>Cornell</source>
        <translation>康奈尔盒</translation>
    </message>
    <message>
        <source>Depth of field</source>
        <translation>景深</translation>
    </message>
    <message>
        <source>Glass study</source>
        <translation>玻璃习作</translation>
    </message>
    <message>
        <source>Many balls</source>
        <translation>许多球</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>材质</translation>
    </message>
    <message>
        <source>Still life</source>
        <translation>静物</translation>
    </message>
</context>
<context>
    <name>glint</name>
    <message>
        <source>%1 m</source>
        <translation>%1 米</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 EV</source>
        <translation>%1 EV</translation>
    </message>
    <message>
        <source>red x, green y, blue z: −1 to 1</source>
        <translation>红 x、绿 y、蓝 z：−1 至 1</translation>
    </message>
    <message>
        <source>red x, green y, blue z: from the least to the largest in view</source>
        <translation>红 x、绿 y、蓝 z：视图中最小值至最大值</translation>
    </message>
    <message>
        <source>one colour each</source>
        <translation>各一种颜色</translation>
    </message>
    <message>
        <source>Beauty</source>
        <translation>成图</translation>
    </message>
    <message>
        <source>Albedo</source>
        <translation>反照率</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>法线</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>材质</translation>
    </message>
    <message>
        <source>Samples a pixel</source>
        <translation>每像素采样</translation>
    </message>
    <message>
        <source>Error (95 % bound)</source>
        <translation>误差（95 % 上限）</translation>
    </message>
    <message>
        <source>Luminance, stops from middle grey</source>
        <translation>亮度，相对中灰的档数</translation>
    </message>
</context>
<context>
    <name>glint::Actions</name>
    <message>
        <source>&amp;New</source>
        <translation>新建(&amp;N)</translation>
    </message>
    <message>
        <source>Start a new scene</source>
        <translation>开始新场景</translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation>起始页(&amp;T)</translation>
    </message>
    <message>
        <source>Templates, demos and recent files</source>
        <translation>模板、示例和最近的文件</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>Open a scene file</source>
        <translation>打开场景文件</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>保存场景</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Save the scene under another name</source>
        <translation>以其他名称保存场景</translation>
    </message>
    <message>
        <source>&amp;Export picture…</source>
        <translation>导出图片(&amp;E)…</translation>
    </message>
    <message>
        <source>Render the picture to a file in the background</source>
        <translation>在后台把画面渲染到文件</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>关闭窗口</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>Take back the last edit</source>
        <translation>撤回上一次编辑</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>Do again what was taken back</source>
        <translation>重做被撤回的编辑</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>剪切(&amp;T)</translation>
    </message>
    <message>
        <source>Copy the selected objects as text and delete them</source>
        <translation>把所选对象复制为文本并删除</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>粘贴(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>复制一份(&amp;D)</translation>
    </message>
    <message>
        <source>Copy the selection; the copy follows the pointer</source>
        <translation>复制所选；副本跟随指针</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>删除(&amp;L)</translation>
    </message>
    <message>
        <source>Delete the selection</source>
        <translation>删除所选</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>全选(&amp;A)</translation>
    </message>
    <message>
        <source>Select every object and light</source>
        <translation>选择所有对象和灯光</translation>
    </message>
    <message>
        <source>Select &amp;none</source>
        <translation>取消选择(&amp;N)</translation>
    </message>
    <message>
        <source>Select nothing</source>
        <translation>不选任何对象</translation>
    </message>
    <message>
        <source>Rena&amp;me</source>
        <translation>重命名(&amp;M)</translation>
    </message>
    <message>
        <source>Rename the active item</source>
        <translation>重命名活动项</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>隐藏(&amp;H)</translation>
    </message>
    <message>
        <source>Hide the selection</source>
        <translation>隐藏所选</translation>
    </message>
    <message>
        <source>&amp;Show all</source>
        <translation>全部显示(&amp;S)</translation>
    </message>
    <message>
        <source>Show everything that is hidden</source>
        <translation>显示所有隐藏的内容</translation>
    </message>
    <message>
        <source>&amp;Group</source>
        <translation>编组(&amp;G)</translation>
    </message>
    <message>
        <source>Put the selection into a new group</source>
        <translation>把所选放入新组</translation>
    </message>
    <message>
        <source>U&amp;ngroup</source>
        <translation>取消编组(&amp;N)</translation>
    </message>
    <message>
        <source>Dissolve the selected groups</source>
        <translation>解散所选的组</translation>
    </message>
    <message>
        <source>Pre&amp;ferences…</source>
        <translation>首选项(&amp;F)…</translation>
    </message>
    <message>
        <source>Theme, language, threads, navigation, shortcuts</source>
        <translation>主题、语言、线程、导航、快捷键</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>选择(&amp;S)</translation>
    </message>
    <message>
        <source>Select only</source>
        <translation>仅选择</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>移动(&amp;M)</translation>
    </message>
    <message>
        <source>Move the selection</source>
        <translation>移动所选</translation>
    </message>
    <message>
        <source>&amp;Rotate</source>
        <translation>旋转(&amp;R)</translation>
    </message>
    <message>
        <source>Turn the selection</source>
        <translation>旋转所选</translation>
    </message>
    <message>
        <source>S&amp;cale</source>
        <translation>缩放(&amp;C)</translation>
    </message>
    <message>
        <source>Scale the selection</source>
        <translation>缩放所选</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>吸附(&amp;N)</translation>
    </message>
    <message>
        <source>Snap to steps; Ctrl while dragging does the opposite</source>
        <translation>吸附到步长；拖动时按 Ctrl 则相反</translation>
    </message>
    <message>
        <source>&amp;Frame selected</source>
        <translation>聚焦所选(&amp;F)</translation>
    </message>
    <message>
        <source>Bring the selection into view</source>
        <translation>把所选纳入视野</translation>
    </message>
    <message>
        <source>Frame &amp;all</source>
        <translation>聚焦全部(&amp;A)</translation>
    </message>
    <message>
        <source>Bring everything into view</source>
        <translation>把全部纳入视野</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>前</translation>
    </message>
    <message>
        <source>Look along −z</source>
        <translation>沿 −z 观察</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>后</translation>
    </message>
    <message>
        <source>Look along +z</source>
        <translation>沿 +z 观察</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Look along −x</source>
        <translation>沿 −x 观察</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>Look along +x</source>
        <translation>沿 +x 观察</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>顶</translation>
    </message>
    <message>
        <source>Look down</source>
        <translation>向下看</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>底</translation>
    </message>
    <message>
        <source>Look up</source>
        <translation>向上看</translation>
    </message>
    <message>
        <source>&amp;Perspective / orthographic</source>
        <translation>透视 / 正交(&amp;P)</translation>
    </message>
    <message>
        <source>Switch the projection, keeping sizes at the target</source>
        <translation>切换投影，保持目标处的大小</translation>
    </message>
    <message>
        <source>Look through &amp;camera</source>
        <translation>从相机观察(&amp;C)</translation>
    </message>
    <message>
        <source>Make the selected camera the active one</source>
        <translation>把所选相机设为活动相机</translation>
    </message>
    <message>
        <source>Pre&amp;vious view</source>
        <translation>上一视图(&amp;V)</translation>
    </message>
    <message>
        <source>Where the view was before</source>
        <translation>回到之前的视图</translation>
    </message>
    <message>
        <source>Ne&amp;xt view</source>
        <translation>下一视图(&amp;X)</translation>
    </message>
    <message>
        <source>Go forward again</source>
        <translation>再次前进</translation>
    </message>
    <message>
        <source>&amp;Overlay</source>
        <translation>叠加层(&amp;O)</translation>
    </message>
    <message>
        <source>Show outlines, handles and marks over the picture</source>
        <translation>在画面上显示轮廓、手柄和标记</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>网格(&amp;G)</translation>
    </message>
    <message>
        <source>Show the ground grid</source>
        <translation>显示地面网格</translation>
    </message>
    <message>
        <source>&amp;Darker</source>
        <translation>变暗(&amp;D)</translation>
    </message>
    <message>
        <source>Half a stop less exposure</source>
        <translation>曝光减半级</translation>
    </message>
    <message>
        <source>&amp;Brighter</source>
        <translation>变亮(&amp;B)</translation>
    </message>
    <message>
        <source>Half a stop more exposure</source>
        <translation>曝光加半级</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>暂停(&amp;P)</translation>
    </message>
    <message>
        <source>Stop rendering and keep the samples</source>
        <translation>停止渲染并保留采样</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>复制画面(&amp;C)</translation>
    </message>
    <message>
        <source>Copy the picture as it is shown</source>
        <translation>按显示复制画面</translation>
    </message>
    <message>
        <source>&amp;Light theme</source>
        <translation>浅色主题(&amp;L)</translation>
    </message>
    <message>
        <source>Switch between dark and light</source>
        <translation>切换深色与浅色</translation>
    </message>
    <message>
        <source>&amp;Shortcuts</source>
        <translation>快捷键(&amp;S)</translation>
    </message>
    <message>
        <source>Show all mouse and keyboard shortcuts</source>
        <translation>显示所有鼠标和键盘操作</translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation>查找命令(&amp;F)…</translation>
    </message>
    <message>
        <source>Search all commands by name</source>
        <translation>按名称搜索所有命令</translation>
    </message>
    <message>
        <source>&amp;About Glint</source>
        <translation>关于 Glint(&amp;A)</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>版本和许可证</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>添加(&amp;A)…</translation>
    </message>
    <message>
        <source>Add something at the pointer</source>
        <translation>在指针处添加</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>编辑</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Render</source>
        <translation>渲染</translation>
    </message>
    <message>
        <source>Window and help</source>
        <translation>窗口与帮助</translation>
    </message>
    <message>
        <source>Copy the selection as text; the picture if nothing is selected</source>
        <translation>把所选复制为文本；未选择时复制画面</translation>
    </message>
    <message>
        <source>Add what is on the clipboard</source>
        <translation>添加剪贴板中的内容</translation>
    </message>
    <message>
        <source>Hide the &amp;rest</source>
        <translation>隐藏其余(&amp;R)</translation>
    </message>
    <message>
        <source>Hide every object but the selected ones</source>
        <translation>隐藏所选以外的所有对象</translation>
    </message>
    <message>
        <source>&amp;Filtered</source>
        <translation>滤波(&amp;F)</translation>
    </message>
    <message>
        <source>Show the picture denoised; samples, error and files stay as they are</source>
        <translation>显示降噪后的画面；采样、误差和文件保持不变</translation>
    </message>
    <message>
        <source>&amp;Region</source>
        <translation>区域(&amp;R)</translation>
    </message>
    <message>
        <source>Mark the only part of the picture that is rendered on; the rest stays</source>
        <translation>标出继续渲染的画面部分；其余保持不变</translation>
    </message>
    <message>
        <source>Whole pic&amp;ture</source>
        <translation>整幅画面(&amp;T)</translation>
    </message>
    <message>
        <source>Render the whole picture again</source>
        <translation>重新渲染整幅画面</translation>
    </message>
    <message>
        <source>Render se&amp;lected only</source>
        <translation>仅渲染所选(&amp;L)</translation>
    </message>
    <message>
        <source>Show the picture with nothing but the selected objects and the lights</source>
        <translation>画面中只显示所选对象和灯光</translation>
    </message>
    <message>
        <source>&amp;Inspect pixel</source>
        <translation>检查像素(&amp;I)</translation>
    </message>
    <message>
        <source>Explain the pixel under the pointer: its paths and what light they found (Alt+click)</source>
        <translation>解释指针下的像素：它的路径及其找到的光（Alt+单击）</translation>
    </message>
    <message>
        <source>&amp;Beauty</source>
        <translation>成图(&amp;B)</translation>
    </message>
    <message>
        <source>Show the picture</source>
        <translation>显示画面</translation>
    </message>
    <message>
        <source>&amp;Albedo</source>
        <translation>反照率(&amp;A)</translation>
    </message>
    <message>
        <source>Show what share of light the surfaces send back</source>
        <translation>显示表面反射光的比例</translation>
    </message>
    <message>
        <source>&amp;Normal</source>
        <translation>法线(&amp;N)</translation>
    </message>
    <message>
        <source>Show which way the surfaces face</source>
        <translation>显示表面的朝向</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>深度(&amp;D)</translation>
    </message>
    <message>
        <source>Show how far the surfaces are</source>
        <translation>显示表面的距离</translation>
    </message>
    <message>
        <source>&amp;Position</source>
        <translation>位置(&amp;P)</translation>
    </message>
    <message>
        <source>Show where the surfaces are</source>
        <translation>显示表面的位置</translation>
    </message>
    <message>
        <source>&amp;Objects</source>
        <translation>对象(&amp;O)</translation>
    </message>
    <message>
        <source>Show a colour for each object</source>
        <translation>每个对象显示一种颜色</translation>
    </message>
    <message>
        <source>&amp;Materials</source>
        <translation>材质(&amp;M)</translation>
    </message>
    <message>
        <source>Show a colour for each material</source>
        <translation>每种材质显示一种颜色</translation>
    </message>
    <message>
        <source>&amp;Samples</source>
        <translation>采样(&amp;S)</translation>
    </message>
    <message>
        <source>Show how many samples each pixel has</source>
        <translation>显示每个像素的采样数</translation>
    </message>
    <message>
        <source>&amp;Error</source>
        <translation>误差(&amp;E)</translation>
    </message>
    <message>
        <source>Show how good each part of the picture is: the 95 % bound of its error</source>
        <translation>显示画面各部分的质量：误差的 95 % 上限</translation>
    </message>
    <message>
        <source>&amp;Luminance</source>
        <translation>亮度(&amp;L)</translation>
    </message>
    <message>
        <source>Show brightness in stops from middle grey</source>
        <translation>以相对中灰的档数显示亮度</translation>
    </message>
    <message>
        <source>E&amp;rror report…</source>
        <translation>误差报告(&amp;R)…</translation>
    </message>
    <message>
        <source>Measure how the error of this scene falls with time</source>
        <translation>测量此场景的误差如何随时间下降</translation>
    </message>
    <message>
        <source>Before the last &amp;step</source>
        <translation>上一步之前(&amp;S)</translation>
    </message>
    <message>
        <source>Show the picture as it was before the last step, to compare; press again to come back</source>
        <translation>显示上一步之前的画面以作比较；再按一次返回</translation>
    </message>
</context>
<context>
    <name>glint::ColorPopup</name>
    <message>
        <source>Red</source>
        <translation>红</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>绿</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>蓝</translation>
    </message>
    <message>
        <source>Linear Rec.709</source>
        <translation>线性 Rec.709</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>亮度</translation>
    </message>
    <message>
        <source>The largest channel; the others keep their ratio to it</source>
        <translation>最大的通道；其余通道保持比例</translation>
    </message>
    <message>
        <source>As in other programs: #rrggbb in sRGB, not linear</source>
        <translation>与其他程序相同：sRGB 的 #rrggbb，非线性</translation>
    </message>
    <message>
        <source>Hex (sRGB)</source>
        <translation>十六进制 (sRGB)</translation>
    </message>
    <message>
        <source>Pick from the picture</source>
        <translation>从画面取色</translation>
    </message>
    <message>
        <source>The next click on the picture takes its linear colour, as it is before the exposure; Esc ends it</source>
        <translation>下一次点击画面时取其曝光前的线性颜色；Esc 结束</translation>
    </message>
</context>
<context>
    <name>glint::CommandSearch</name>
    <message>
        <source>Find a command</source>
        <translation>查找命令</translation>
    </message>
</context>
<context>
    <name>glint::Document</name>
    <message>
        <source>Untitled</source>
        <translation>未命名</translation>
    </message>
</context>
<context>
    <name>glint::DragNumber</name>
    <message>
        <source>a whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数值</translation>
    </message>
    <message>
        <source> above %1</source>
        <translation>，大于 %1</translation>
    </message>
    <message>
        <source> from %1</source>
        <translation>，不小于 %1</translation>
    </message>
    <message>
        <source> up to %1</source>
        <translation>，不大于 %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number</source>
        <translation>“%1”不是数值</translation>
    </message>
    <message>
        <source>%1 is not %2</source>
        <translation>%1 不符合：%2</translation>
    </message>
</context>
<context>
    <name>glint::EditController</name>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>复制一份</translation>
    </message>
    <message>
        <source>The clipboard holds no objects: %1</source>
        <translation>剪贴板中没有对象：%1</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>粘贴</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>全部显示</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>编组</translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>取消编组</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>曝光</translation>
    </message>
    <message>
        <source>Look through camera</source>
        <translation>从相机观察</translation>
    </message>
    <message>
        <source>Ball light</source>
        <translation>球灯</translation>
    </message>
    <message>
        <source>%1 light</source>
        <translation>%1灯</translation>
    </message>
    <message>
        <source>Camera from view</source>
        <translation>由当前视图建相机</translation>
    </message>
    <message>
        <source>Empty group</source>
        <translation>空组</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>添加%1</translation>
    </message>
    <message>
        <source>Add ball light</source>
        <translation>添加球灯</translation>
    </message>
    <message>
        <source>Add light</source>
        <translation>添加灯光</translation>
    </message>
    <message>
        <source>Add group</source>
        <translation>添加组</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Add camera</source>
        <translation>添加相机</translation>
    </message>
    <message>
        <source>Hide the rest</source>
        <translation>隐藏其余</translation>
    </message>
</context>
<context>
    <name>glint::EnvironmentDials</name>
    <message>
        <source>Turn of the environment</source>
        <translation>环境的旋转</translation>
    </message>
    <message>
        <source>Drag to turn the environment, Shift for fine steps.
In the picture: Shift, then drag with the right button</source>
        <translation>拖动以旋转环境，Shift 微调。
在画面中：按住 Shift 再用右键拖动</translation>
    </message>
    <message>
        <source>Place of the sun</source>
        <translation>太阳的位置</translation>
    </message>
    <message>
        <source>Drag the sun: the middle is overhead, the rim is the horizon</source>
        <translation>拖动太阳：中心为天顶，边缘为地平线</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>方位角</translation>
    </message>
    <message>
        <source>Direction of the sun, clockwise from −z seen from above</source>
        <translation>太阳的方向，从上方看自 −z 起顺时针</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>高度角</translation>
    </message>
    <message>
        <source>Height of the sun above the horizon</source>
        <translation>太阳在地平线以上的高度</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Turn environment</source>
        <translation>旋转环境</translation>
    </message>
    <message>
        <source>Move sun</source>
        <translation>移动太阳</translation>
    </message>
</context>
<context>
    <name>glint::EnvironmentPicker</name>
    <message>
        <source>Environment</source>
        <translation>环境</translation>
    </message>
    <message>
        <source>Open picture…</source>
        <translation>打开图像…</translation>
    </message>
    <message>
        <source>Any latitude-longitude picture: EXR, HDR, PNG, JPEG, TIFF</source>
        <translation>任意经纬图：EXR、HDR、PNG、JPEG、TIFF</translation>
    </message>
    <message>
        <source>Environment settings</source>
        <translation>环境设置</translation>
    </message>
    <message>
        <source>Environment pictures</source>
        <translation>环境图像</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>No picture: the colour below alone</source>
        <translation>无图像：仅用下面的颜色</translation>
    </message>
    <message>
        <source>Computed sky</source>
        <translation>计算天空</translation>
    </message>
    <message>
        <source>Sky and sun, computed from the place of the sun</source>
        <translation>由太阳位置计算的天空和太阳</translation>
    </message>
    <message>
        <source>Environment picture</source>
        <translation>环境图像</translation>
    </message>
    <message>
        <source>No environment picture</source>
        <translation>无环境图像</translation>
    </message>
    <message>
        <source>Open an environment picture</source>
        <translation>打开环境图像</translation>
    </message>
    <message>
        <source>Pictures (*.exr *.hdr *.png *.jpg *.jpeg *.tif *.tiff)</source>
        <translation>图像 (*.exr *.hdr *.png *.jpg *.jpeg *.tif *.tiff)</translation>
    </message>
</context>
<context>
    <name>glint::ErrorReportDialog</name>
    <message>
        <source>Error report</source>
        <translation>误差报告</translation>
    </message>
    <message>
        <source>Measuring at %1 × %2 pixels: %3 renders of each number of samples against a reference by another estimator.</source>
        <translation>以 %1 × %2 像素测量：每种采样数渲染 %3 次，与另一种估计方法的参考图比较。</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>采样</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>relMSE</source>
        <translation>相对均方误差</translation>
    </message>
    <message>
        <source>Mean error %</source>
        <translation>平均误差 %</translation>
    </message>
    <message>
        <source>99th percentile %</source>
        <translation>第 99 百分位 %</translation>
    </message>
    <message>
        <source>Outliers %</source>
        <translation>离群值 %</translation>
    </message>
    <message>
        <source>Save CSV…</source>
        <translation>保存 CSV…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>%1 × %2 pixels.</source>
        <translation>%1 × %2 像素。</translation>
    </message>
    <message>
        <source>relMSE falls as samples to the power of %1 ± %2 (−1: as chance has it); efficiency 1 / (relMSE · time) is %3 per second.</source>
        <translation>相对均方误差按采样数的 %1 ± %2 次幂下降（−1：随机情形）；效率 1 /（相对均方误差 · 时间）为每秒 %3。</translation>
    </message>
    <message>
        <source>This picture has no noise that could be measured.</source>
        <translation>此画面没有可测量的噪点。</translation>
    </message>
    <message>
        <source>this scene</source>
        <translation>此场景</translation>
    </message>
    <message>
        <source>Error over time</source>
        <translation>误差随时间变化</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>Save CSV</source>
        <translation>保存 CSV</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
</context>
<context>
    <name>glint::ExportDialog</name>
    <message>
        <source>Export picture</source>
        <translation>导出图片</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>浏览…</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>图片 (%1)</translation>
    </message>
    <message>
        <source>The ending chooses the format</source>
        <translation>扩展名决定格式</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>PNG, for the screen</source>
        <translation>PNG，用于屏幕</translation>
    </message>
    <message>
        <source>JPEG, small</source>
        <translation>JPEG，较小</translation>
    </message>
    <message>
        <source>TIFF, for the screen</source>
        <translation>TIFF，用于屏幕</translation>
    </message>
    <message>
        <source>OpenEXR, linear light</source>
        <translation>OpenEXR，线性光</translation>
    </message>
    <message>
        <source>Radiance HDR, linear light</source>
        <translation>Radiance HDR，线性光</translation>
    </message>
    <message>
        <source>Bits a channel</source>
        <translation>每通道位数</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>As the scene says, %1</source>
        <translation>按场景设置，%1</translation>
    </message>
    <message>
        <source>Keep the ratio of width and height</source>
        <translation>保持宽高比</translation>
    </message>
    <message>
        <source>Percent of that size</source>
        <translation>该尺寸的百分比</translation>
    </message>
    <message>
        <source>Samples a pixel to stop at</source>
        <translation>达到此每像素采样数时停止</translation>
    </message>
    <message>
        <source>Time to stop at; 0 is no limit</source>
        <translation>达到此时间时停止；0 表示不限</translation>
    </message>
    <message>
        <source>Error of the picture to stop at; 0 is no limit</source>
        <translation>达到此误差时停止；0 表示不限</translation>
    </message>
    <message>
        <source>Stop at</source>
        <translation>停止条件</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>透明背景</translation>
    </message>
    <message>
        <source>An alpha channel instead of the environment behind the objects</source>
        <translation>用 Alpha 通道代替对象后面的环境</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>Light by kind, albedo, normal, depth, position, ids, sample count and error beside the picture</source>
        <translation>在画面之外附带分类光照、反照率、法线、深度、位置、编号、采样数和误差</translation>
    </message>
    <message>
        <source>Content</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Left edge</source>
        <translation>左边缘</translation>
    </message>
    <message>
        <source>Upper edge</source>
        <translation>上边缘</translation>
    </message>
    <message>
        <source>Width of the part</source>
        <translation>区域宽度</translation>
    </message>
    <message>
        <source>Height of the part</source>
        <translation>区域高度</translation>
    </message>
    <message>
        <source>Only a part</source>
        <translation>仅一部分</translation>
    </message>
    <message>
        <source>Number of pictures</source>
        <translation>图片数量</translation>
    </message>
    <message>
        <source>Turn over all pictures</source>
        <translation>全部图片的总转角</translation>
    </message>
    <message>
        <source>Axis to turn about, through the camera&apos;s target</source>
        <translation>旋转轴，经过相机目标点</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>转台</translation>
    </message>
    <message>
        <source>%1 bits</source>
        <translation>%1 位</translation>
    </message>
    <message>
        <source>The part reaches out of the picture of %1 pixels</source>
        <translation>该区域超出 %1 像素的画面</translation>
    </message>
    <message>
        <source>There is no folder %1</source>
        <translation>没有文件夹 %1</translation>
    </message>
    <message>
        <source>%1 pixels</source>
        <translation>%1 像素</translation>
    </message>
    <message numerus="yes">
        <source> · %n picture(s): %1 …</source>
        <translation>
            <numerusform> · %n 张图片：%1 …</numerusform>
        </translation>
    </message>
    <message>
        <source> · replaces the file that is there</source>
        <translation> · 替换已有文件</translation>
    </message>
</context>
<context>
    <name>glint::ExportPanel</name>
    <message>
        <source>Exports</source>
        <translation>导出队列</translation>
    </message>
    <message>
        <source>No exports. F12 renders the picture to a file.</source>
        <translation>没有导出任务。按 F12 把画面渲染到文件。</translation>
    </message>
    <message>
        <source>Take finished exports off the list</source>
        <translation>从列表中移除已完成的导出</translation>
    </message>
    <message>
        <source>Pause, or go on</source>
        <translation>暂停或继续</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>glint::ExportQueue</name>
    <message>
        <source>Not exported: %1</source>
        <translation>未导出：%1</translation>
    </message>
    <message>
        <source>Export canceled</source>
        <translation>导出已取消</translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>已导出 %1</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Exported %1 pictures %2</source>
        <translation>已导出 %1 张图片 %2</translation>
    </message>
</context>
<context>
    <name>glint::FileController</name>
    <message>
        <source>Not opened: %1</source>
        <translation>未打开：%1</translation>
    </message>
    <message>
        <source>Open a scene</source>
        <translation>打开场景</translation>
    </message>
    <message>
        <source>Scenes (*.json)</source>
        <translation>场景 (*.json)</translation>
    </message>
    <message numerus="yes">
        <source>Open without %n bad part(s)</source>
        <translation>
            <numerusform>忽略 %n 个损坏部分并打开</numerusform>
        </translation>
    </message>
    <message>
        <source>Opened in part, as an untitled scene. Left out:
%1</source>
        <translation>已部分打开为未命名场景。未包含：
%1</translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation>未保存：%1</translation>
    </message>
    <message>
        <source>Save elsewhere…</source>
        <translation>存到别处…</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>保存场景</translation>
    </message>
    <message>
        <source>scene.glint.json</source>
        <translation>场景.glint.json</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>未保存的更改</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has changes that are not saved.</source>
        <translation>“%1”有未保存的更改。</translation>
    </message>
</context>
<context>
    <name>glint::HueSquare</name>
    <message>
        <source>Hue, saturation and value</source>
        <translation>色相、饱和度和明度</translation>
    </message>
</context>
<context>
    <name>glint::MainMenus</name>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>New from &amp;template</source>
        <translation>由模板新建(&amp;T)</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>打开最近的文件(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>添加(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>Ca&amp;meras</source>
        <translation>相机(&amp;M)</translation>
    </message>
    <message>
        <source>Sa&amp;ved views</source>
        <translation>已存视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Render</source>
        <translation>渲染(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Channel</source>
        <translation>通道(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>窗口(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Inspect pixel</source>
        <translation>检查像素(&amp;I)</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Go to view %1</source>
        <translation>前往视图 %1</translation>
    </message>
    <message>
        <source>Store as view %1</source>
        <translation>存为视图 %1</translation>
    </message>
</context>
<context>
    <name>glint::MainWindow</name>
    <message>
        <source>As opened</source>
        <translation>打开时的状态</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>材质</translation>
    </message>
    <message>
        <source>Environment</source>
        <translation>环境</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>Render</source>
        <translation>渲染</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>统计</translation>
    </message>
    <message numerus="yes">
        <source>%n selected</source>
        <translation>
            <numerusform>已选 %n 项</numerusform>
        </translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Exports</source>
        <translation>导出队列</translation>
    </message>
    <message>
        <source>Reloaded %1</source>
        <translation>已重新载入 %1</translation>
    </message>
    <message>
        <source>%1 was changed by another program</source>
        <translation>%1 已被其他程序修改</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>重新载入</translation>
    </message>
    <message>
        <source>Unsaved work cannot be kept safe: %1</source>
        <translation>无法保护未保存的工作：%1</translation>
    </message>
    <message>
        <source>an untitled scene</source>
        <translation>未命名场景</translation>
    </message>
    <message>
        <source>Not recovered: %1</source>
        <translation>未恢复：%1</translation>
    </message>
    <message>
        <source>Glint ended with unsaved changes to %1, kept at %2.</source>
        <translation>Glint 结束时 %1 有未保存的更改，已保存于 %2。</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>丢弃</translation>
    </message>
    <message>
        <source>Pixel</source>
        <translation>像素</translation>
    </message>
</context>
<context>
    <name>glint::MaterialDrop</name>
    <message>
        <source>Assign material</source>
        <translation>指定材质</translation>
    </message>
</context>
<context>
    <name>glint::MaterialModel</name>
    <message numerus="yes">
        <source>%1: %2, %n object(s)
Drag it onto an object</source>
        <translation>
            <numerusform>%1：%2，%n 个对象使用
可拖到对象上</numerusform>
        </translation>
    </message>
    <message>
        <source>A name must not be empty</source>
        <translation>名称不能为空</translation>
    </message>
    <message>
        <source>Another one has the name &quot;%1&quot;</source>
        <translation>已有名为“%1”的</translation>
    </message>
    <message>
        <source>Rename material</source>
        <translation>重命名材质</translation>
    </message>
</context>
<context>
    <name>glint::MaterialPanel</name>
    <message>
        <source>Materials</source>
        <translation>材质</translation>
    </message>
    <message>
        <source>New material</source>
        <translation>新材质</translation>
    </message>
    <message>
        <source>New material, from presets with measured constants</source>
        <translation>新材质，来自实测常数的预设</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新建</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>指定</translation>
    </message>
    <message>
        <source>Give it to the selected objects</source>
        <translation>赋予所选对象</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>复制一份</translation>
    </message>
    <message>
        <source>Duplicate the material</source>
        <translation>复制此材质</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Delete the material (Del); objects that have it become black</source>
        <translation>删除此材质 (Del)；使用它的对象变为黑色</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>添加%1</translation>
    </message>
    <message>
        <source>Assign material</source>
        <translation>指定材质</translation>
    </message>
    <message>
        <source>Duplicate material</source>
        <translation>复制材质</translation>
    </message>
    <message>
        <source>Delete material</source>
        <translation>删除材质</translation>
    </message>
    <message>
        <source>Delete unused materials</source>
        <translation>删除未使用的材质</translation>
    </message>
    <message>
        <source>Assign to selection</source>
        <translation>指定给所选</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>Delete unused</source>
        <translation>删除未使用的</translation>
    </message>
</context>
<context>
    <name>glint::MessageBar</name>
    <message>
        <source>Dismiss</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>glint::MissingAssets</name>
    <message>
        <source>The environment&apos;s picture %1 cannot be shown: %2</source>
        <translation>无法显示环境图片 %1：%2</translation>
    </message>
    <message>
        <source>Locate…</source>
        <translation>查找…</translation>
    </message>
    <message>
        <source>Leave it out</source>
        <translation>不使用</translation>
    </message>
</context>
<context>
    <name>glint::ObjectList</name>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Search objects</source>
        <translation>搜索对象</translation>
    </message>
    <message>
        <source>Add (Shift+A)</source>
        <translation>添加 (Shift+A)</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>对象</translation>
    </message>
</context>
<context>
    <name>glint::ObjectModel</name>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Visible: click to hide</source>
        <translation>可见：点击隐藏</translation>
    </message>
    <message>
        <source>Hidden: click to show</source>
        <translation>已隐藏：点击显示</translation>
    </message>
    <message>
        <source>Locked: click to unlock</source>
        <translation>已锁定：点击解锁</translation>
    </message>
    <message>
        <source>Click to lock: it cannot be picked then</source>
        <translation>点击锁定：锁定后不能选取</translation>
    </message>
    <message>
        <source>A name must not be empty</source>
        <translation>名称不能为空</translation>
    </message>
    <message>
        <source>Another one has the name &quot;%1&quot;</source>
        <translation>已有名为“%1”的</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>解锁</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>锁定</translation>
    </message>
    <message>
        <source>Assign material</source>
        <translation>指定材质</translation>
    </message>
    <message>
        <source>Move into group</source>
        <translation>移入组</translation>
    </message>
    <message>
        <source>Move out of group</source>
        <translation>移出组</translation>
    </message>
</context>
<context>
    <name>glint::PixelInspector</name>
    <message>
        <source>Alt+click a pixel of the picture, or choose “Inspect pixel” in its menu.</source>
        <translation>按住 Alt 单击画面中的像素，或在其菜单中选择“检查像素”。</translation>
    </message>
    <message>
        <source>Sample </source>
        <translation>采样 </translation>
    </message>
    <message>
        <source>Which of the pixel&apos;s samples is explained</source>
        <translation>解释该像素的哪个采样</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>Adds</source>
        <translation>贡献</translation>
    </message>
    <message>
        <source>How</source>
        <translation>方式</translation>
    </message>
    <message>
        <source>Light that this and all below it add to the sample: red, green, blue</source>
        <translation>此项及其下所有项为该采样贡献的光：红、绿、蓝</translation>
    </message>
    <message>
        <source>Paths of the sample</source>
        <translation>该采样的路径</translation>
    </message>
    <message>
        <source>There is no picture at this pixel.</source>
        <translation>此像素处没有画面。</translation>
    </message>
    <message>
        <source>Pixel %1, %2: radiance %3</source>
        <translation>像素 %1, %2：辐亮度 %3</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>样本</translation>
    </message>
    <message>
        <source>Pixel %1, %2</source>
        <translation>像素 %1, %2</translation>
    </message>
</context>
<context>
    <name>glint::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>首选项</translation>
    </message>
    <message>
        <source>General</source>
        <translation>常规</translation>
    </message>
    <message>
        <source>Navigation</source>
        <translation>导航</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>Both are neutral grey, so that they do not tint the picture</source>
        <translation>两者都是中性灰，不影响对画面颜色的判断</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Changes at once</source>
        <translation>立即生效</translation>
    </message>
    <message>
        <source>Render threads</source>
        <translation>渲染线程</translation>
    </message>
    <message>
        <source>Threads that draw the picture; 0: one for each processor</source>
        <translation>绘制画面的线程数；0：每个处理器一个</translation>
    </message>
    <message>
        <source>Save automatically every</source>
        <translation>自动保存间隔</translation>
    </message>
    <message>
        <source>A copy for recovery, beside the file; 0: never</source>
        <translation>文件旁的恢复副本；0：从不</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>起始页</translation>
    </message>
    <message>
        <source>Show demos and recent files when the program starts without a scene</source>
        <translation>未带场景启动时显示示例和最近的文件</translation>
    </message>
    <message>
        <source>Wheel backwards</source>
        <translation>滚轮反向</translation>
    </message>
    <message>
        <source>Turning the wheel towards you comes closer</source>
        <translation>向身前滚动时拉近</translation>
    </message>
    <message>
        <source>Orbit about the selection</source>
        <translation>绕所选对象环绕</translation>
    </message>
    <message>
        <source>Off: about the point under the pointer</source>
        <translation>关闭时：绕指针下的点</translation>
    </message>
</context>
<context>
    <name>glint::PresetPicker</name>
    <message>
        <source>Material presets</source>
        <translation>材质预设</translation>
    </message>
    <message>
        <source>Search presets</source>
        <translation>搜索预设</translation>
    </message>
</context>
<context>
    <name>glint::PreviewBall</name>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
</context>
<context>
    <name>glint::PropertyPanel</name>
    <message>
        <source>Properties</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>Nothing selected.
Click an object in the picture or in the list.</source>
        <translation>未选择任何对象。
请在画面或列表中点击一个对象。</translation>
    </message>
</context>
<context>
    <name>glint::RenderPanel</name>
    <message>
        <source>Render</source>
        <translation>渲染</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>底片</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Render settings</source>
        <translation>渲染设置</translation>
    </message>
</context>
<context>
    <name>glint::RenderView</name>
    <message>
        <source>Picture</source>
        <translation>画面</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>对焦</translation>
    </message>
    <message>
        <source>Paused (Space)</source>
        <translation>已暂停（空格）</translation>
    </message>
    <message>
        <source>Preparing the picture…</source>
        <translation>正在准备画面…</translation>
    </message>
    <message>
        <source>This scene is empty. Shift+A adds an object; drop a scene or an environment picture here.</source>
        <translation>场景为空。按 Shift+A 添加对象，或把场景、环境图像拖到这里。</translation>
    </message>
    <message>
        <source>Drag the region that is to be rendered (Esc: not now)</source>
        <translation>拖出要渲染的区域（Esc：取消）</translation>
    </message>
    <message>
        <source>Only some objects are rendered (/ shows all)</source>
        <translation>仅渲染部分对象（/ 显示全部）</translation>
    </message>
    <message>
        <source>Filtered</source>
        <translation>已滤波</translation>
    </message>
    <message>
        <source>Before the last step (B comes back)</source>
        <translation>上一步之前（按 B 返回）</translation>
    </message>
</context>
<context>
    <name>glint::ShortcutPage</name>
    <message>
        <source>Click a field and press the new keys. They count at once.</source>
        <translation>点击一项并按下新的按键，立即生效。</translation>
    </message>
    <message>
        <source>Reset all keys</source>
        <translation>恢复全部按键</translation>
    </message>
    <message>
        <source>%1 belongs to &quot;%2&quot; already.</source>
        <translation>%1 已属于“%2”。</translation>
    </message>
</context>
<context>
    <name>glint::ShortcutSheet</name>
    <message>
        <source>Shortcuts</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>Select, extend</source>
        <translation>选择、追加</translation>
    </message>
    <message>
        <source>Left click, Shift + left click</source>
        <translation>左键单击，Shift + 左键单击</translation>
    </message>
    <message>
        <source>Select in a box</source>
        <translation>框选</translation>
    </message>
    <message>
        <source>Left drag on empty ground</source>
        <translation>在空白处左键拖动</translation>
    </message>
    <message>
        <source>Orbit about the point under the pointer</source>
        <translation>绕指针下的点环绕</translation>
    </message>
    <message>
        <source>Middle drag, Alt + left drag</source>
        <translation>中键拖动，Alt + 左键拖动</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>平移</translation>
    </message>
    <message>
        <source>Shift + middle drag, Alt + middle drag</source>
        <translation>Shift + 中键拖动，Alt + 中键拖动</translation>
    </message>
    <message>
        <source>Dolly towards the pointer</source>
        <translation>向指针推近</translation>
    </message>
    <message>
        <source>Wheel, Alt + right drag</source>
        <translation>滚轮，Alt + 右键拖动</translation>
    </message>
    <message>
        <source>Fly</source>
        <translation>飞行</translation>
    </message>
    <message>
        <source>Right button held: W A S D, Q E; wheel speed; Shift fast</source>
        <translation>按住右键：W A S D、Q E；滚轮调速；Shift 加速</translation>
    </message>
    <message>
        <source>Turn the environment</source>
        <translation>旋转环境</translation>
    </message>
    <message>
        <source>Shift, then right drag</source>
        <translation>按住 Shift 再右键拖动</translation>
    </message>
    <message>
        <source>Focus here</source>
        <translation>在此对焦</translation>
    </message>
    <message>
        <source>Ctrl + left click</source>
        <translation>Ctrl + 左键单击</translation>
    </message>
    <message>
        <source>While a handle is dragged</source>
        <translation>拖动手柄时</translation>
    </message>
    <message>
        <source>X Y Z lock, Ctrl snap, Shift fine, type a number, Esc cancels</source>
        <translation>X Y Z 锁定，Ctrl 吸附，Shift 微调，可键入数值，Esc 取消</translation>
    </message>
    <message>
        <source>Saved views</source>
        <translation>已存视图</translation>
    </message>
    <message>
        <source>Ctrl+1…9 go, Ctrl+Shift+1…9 store</source>
        <translation>Ctrl+1…9 前往，Ctrl+Shift+1…9 存储</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>鼠标</translation>
    </message>
</context>
<context>
    <name>glint::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>起始页</translation>
    </message>
    <message>
        <source>New from a template</source>
        <translation>由模板新建</translation>
    </message>
    <message>
        <source>Demos</source>
        <translation>示例</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>最近</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Go to the picture (Esc)</source>
        <translation>转到画面 (Esc)</translation>
    </message>
    <message>
        <source>Open a scene…</source>
        <translation>打开场景…</translation>
    </message>
    <message>
        <source>or drop a scene or an environment picture here</source>
        <translation>或把场景、环境图像拖到这里</translation>
    </message>
</context>
<context>
    <name>glint::StatisticsPanel</name>
    <message>
        <source>Statistics</source>
        <translation>统计</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>组</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>灯光</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>材质</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>画面</translation>
    </message>
    <message>
        <source>Samples a pixel</source>
        <translation>每像素采样</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Error of the picture</source>
        <translation>画面误差</translation>
    </message>
    <message>
        <source>Rays a second</source>
        <translation>每秒光线</translation>
    </message>
    <message>
        <source>Kernel</source>
        <translation>内核</translation>
    </message>
    <message>
        <source>The scene holds</source>
        <translation>场景包含</translation>
    </message>
    <message>
        <source>Faulty samples</source>
        <translation>错误采样</translation>
    </message>
    <message>
        <source>%1 × %2 px</source>
        <translation>%1 × %2 像素</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>± %1 %</source>
        <translation>± %1 %</translation>
    </message>
    <message>
        <source>%1 million</source>
        <translation>%1 百万</translation>
    </message>
</context>
<context>
    <name>glint::StatusLine</name>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 分 %2 秒</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>已暂停</translation>
    </message>
    <message>
        <source>done</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>What the picture cannot show as the scene asks</source>
        <translation>画面无法按场景要求显示的内容</translation>
    </message>
    <message>
        <source>%1 / %2 spp</source>
        <translation>%1 / %2 采样</translation>
    </message>
    <message>
        <source>%1 spp</source>
        <translation>%1 采样</translation>
    </message>
    <message>
        <source>± %1 %</source>
        <translation>± %1 %</translation>
    </message>
    <message>
        <source>%1 Mray/s</source>
        <translation>%1 百万光线/秒</translation>
    </message>
    <message numerus="yes">
        <source>%n faulty sample(s)</source>
        <translation>
            <numerusform>%n 个错误采样</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 × %2 px</source>
        <translation>%1 × %2 像素</translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation>
            <numerusform>%n 条警告</numerusform>
        </translation>
    </message>
    <message>
        <source>Kernel: %1
The scene holds: %2
Left out: %3</source>
        <translation>内核：%1
场景包含：%2
未用：%3</translation>
    </message>
    <message>
        <source>%1, done in %2</source>
        <translation>%1，%2 后完成</translation>
    </message>
    <message>
        <source>filtered</source>
        <translation>已滤波</translation>
    </message>
    <message>
        <source>region</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>clamped, hence biased</source>
        <translation>已钳制，故有偏差</translation>
    </message>
    <message>
        <source>%1 at the pointer</source>
        <translation>指针处 %1</translation>
    </message>
</context>
<context>
    <name>glint::ToolBar</name>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>World</source>
        <translation>世界</translation>
    </message>
    <message>
        <source>Local</source>
        <translation>局部</translation>
    </message>
    <message>
        <source>Axes of the handles</source>
        <translation>手柄的坐标轴</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>中点</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>活动项</translation>
    </message>
    <message>
        <source>Individual</source>
        <translation>各自</translation>
    </message>
    <message>
        <source>Point that turns and scales go about</source>
        <translation>旋转和缩放的中心</translation>
    </message>
    <message>
        <source>How light is traced</source>
        <translation>光线追踪的方式</translation>
    </message>
    <message>
        <source>Exposure: each step doubles the brightness ([ and ])</source>
        <translation>曝光：每级亮度加倍（[ 和 ]）</translation>
    </message>
</context>
<context>
    <name>glint::ViewCommands</name>
    <message>
        <source>Store view %1</source>
        <translation>存储视图 %1</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Scene editor whose viewport is a ray tracer.</source>
        <translation>以光线追踪为视图的场景编辑器。</translation>
    </message>
    <message>
        <source>Scene file to open.</source>
        <translation>要打开的场景文件。</translation>
    </message>
</context>
</TS>
