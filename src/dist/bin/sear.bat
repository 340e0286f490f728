@echo off
rem Runs SEARs command line: sear SCRIPT.py [options], sear check, sear sensors, sear install. JAVA_OPTS adds options for the JVM.
setlocal
set HOME_DIR=%~dp0..
set JAVA_CMD=java
if not "%JAVA_HOME%"=="" set JAVA_CMD=%JAVA_HOME%\bin\java
set SEAR_TERMINAL=1
"%JAVA_CMD%" %JAVA_OPTS% -Dsear.home="%HOME_DIR%" -cp "%HOME_DIR%\plugin\*;%HOME_DIR%\lib\*" org.SEAR.cli.SearCommand %*
exit /b %ERRORLEVEL%
