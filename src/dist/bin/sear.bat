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
rem Java 24 and newer warn about operations of the server of the tabs, Jython, LWJGL and JNA without these options; older ones do not know them.
set "QUIET=-Xlog:cds=off -XX:+IgnoreUnrecognizedVMOptions --sun-misc-unsafe-memory-access=allow --enable-native-access=ALL-UNNAMED"
rem A simulation needs some 20 MB: the default collector of big machines would use 300 MB before it collects garbage.
rem Archived classes are mapped at their recorded addresses: relocation, the default since Java 17, would rewrite all addresses.
set "MEMORY=-XX:+UseSerialGC -Xms64m -XX:+UnlockDiagnosticVMOptions -XX:ArchiveRelocationMode=0"
rem The optimizing compiler of the JVM starts after ten times as many runs as by default: at the start it would use most of the time.
set "COMPILER=-XX:Tier4InvocationThreshold=50000 -XX:Tier4CompileThreshold=150000 -XX:Tier4BackEdgeThreshold=400000 -XX:Tier3DelayOn=0"
rem Class archive of the build; another Java ignores it silently.
set "ARCHIVE="
if exist "%HOME_DIR%\lib\sear.jsa" set ARCHIVE="-XX:SharedArchiveFile=%HOME_DIR%\lib\sear.jsa"
"%JAVA_CMD%" %QUIET% %MEMORY% %COMPILER% %ARCHIVE% %JAVA_OPTS% -Dsear.home="%HOME_DIR%" -cp "%HOME_DIR%\plugin\*;%HOME_DIR%\lib\*" org.SEAR.cli.SearCommand %*
exit /b %ERRORLEVEL%
