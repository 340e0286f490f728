@echo off
rem Runs SEARs command line: sear SCRIPT.py [options], sear check, sear sensors, sear install. JAVA_OPTS adds options for the JVM.
setlocal
set "HOME_DIR=%~dp0.."
set "JAVA_CMD=java"
if defined JAVA_HOME if exist "%JAVA_HOME%\bin\java.exe" set "JAVA_CMD=%JAVA_HOME%\bin\java.exe"
if not "%JAVA_CMD%"=="java" goto start
where /q java
if not errorlevel 1 goto start
echo sear: needs Java 11 or newer on the PATH (or JAVA_HOME set): install it, for example from https://adoptium.net. 1>&2
exit /b 1
:start
set SEAR_TERMINAL=1
rem Java 24 and newer warn of what the server of the tabs, Jython, LWJGL and JNA do unless they are told; older ones do not know how to be told.
set "QUIET=-Xlog:cds=off -XX:+IgnoreUnrecognizedVMOptions --sun-misc-unsafe-memory-access=allow --enable-native-access=ALL-UNNAMED"
rem A simulation lives in some 20 MB: the collector that big machines get by default would take 300 before it tidies up.
rem Classes from an archive lie where it says: elsewhere, as is the default from Java 17 on, each address among them is written anew at each start.
set "MEMORY=-XX:+UseSerialGC -Xms64m -XX:+UnlockDiagnosticVMOptions -XX:ArchiveRelocationMode=0"
rem The JVM's best compiler takes what has run ten times as often as it would by itself: at the start it took more time than all else.
set "COMPILER=-XX:Tier4InvocationThreshold=50000 -XX:Tier4CompileThreshold=150000 -XX:Tier4BackEdgeThreshold=400000 -XX:Tier3DelayOn=0"
rem The build writes down what the JVM knows of these classes; another Java passes over that without a word.
set "ARCHIVE="
if exist "%HOME_DIR%\lib\sear.jsa" set ARCHIVE="-XX:SharedArchiveFile=%HOME_DIR%\lib\sear.jsa"
"%JAVA_CMD%" %QUIET% %MEMORY% %COMPILER% %ARCHIVE% %JAVA_OPTS% -Dsear.home="%HOME_DIR%" -cp "%HOME_DIR%\plugin\*;%HOME_DIR%\lib\*" org.SEAR.cli.SearCommand %*
exit /b %ERRORLEVEL%
