$---------------------------------------------------------------------MDI_HEADER
[MDI_HEADER]
 FILE_TYPE     =  'dpr'
 FILE_VERSION  =  7.0
 FILE_FORMAT   =  'ASCII'
$--------------------------------------------------------------------------UNITS
[UNITS]
 LENGTH  =  'mm'
 FORCE   =  'newton'
 ANGLE   =  'deg'
 MASS    =  'kg'
 TIME    =  'sec'
[CURVE]
{   vel       force}
-1000.0   -1200.0
-100.0   -400.0
0.0   0.0
100.0   800.0
1000.0   2500.0
