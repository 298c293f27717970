@echo off
rem Rasterlab's front door on Windows: builds what is not built yet, then runs it. "lab help" lists the commands.
setlocal EnableExtensions DisableDelayedExpansion
set "root=%~dp0"
if "%root:~-1%"=="\" set "root=%root:~0,-1%"
set "state=%root%\target\lab"
set "log=%state%\build.log"
set "stamp=%state%\built"
rem In front of a program of its own, --lang is one of that program's options; "=" parts words like a space.
set "command=%~1"
set "language="
if "%~1"=="--lang" for %%W in (bench grader) do if "%~3"=="%%W" (
    set "command=%%W"
    set "language=--lang %~2"
)
rem The help of the server's commands is a command of the server.
if "%~1 %~2"=="help grader" set "command=grader"
set "parts=app,grader"
rem The benchmarks are built only for who measures.
if "%command%"=="bench" (
    set "stamp=%state%\built-bench"
    set "parts=tests"
)

set "java="
if defined JAVA_HOME if exist "%JAVA_HOME%\bin\java.exe" set "java=%JAVA_HOME%\bin\java.exe"
if not defined java for %%J in (java.exe) do set "java=%%~$PATH:J"
if not defined java (
    echo lab: no Java found; install a JDK 17 or later, or set JAVA_HOME to one 1>&2
    exit /b 2
)
set "version="
set "home="
for /f "tokens=1,* delims== " %%A in ('""%java%" -XshowSettings:properties -version 2>&1"') do (
    if "%%A"=="java.specification.version" set "version=%%B"
    if "%%A"=="java.home" set "home=%%B"
)
if not defined version (
    echo lab: "%java%" does not start; set JAVA_HOME to a JDK 17 or later 1>&2
    exit /b 2
)
set "major=%version%"
if "%version:~0,2%"=="1." set "major=1"
if %major% LSS 17 (
    echo lab: "%java%" is Java %version%; Rasterlab needs a JDK 17 or later ^(set JAVA_HOME to one^) 1>&2
    exit /b 2
)
if not exist "%home%\bin\javac.exe" (
    echo lab: "%home%" is Java without a compiler; Rasterlab needs a whole JDK 17 or later ^(set JAVA_HOME to one^) 1>&2
    exit /b 2
)

if not exist "%root%\app\java-options" (
    echo lab: "%root%\app\java-options" is missing; it belongs to Rasterlab's sources, get them anew 1>&2
    exit /b 1
)

call :stale
if not errorlevel 1 goto run
if not exist "%state%" mkdir "%state%"
if not exist "%state%" (
    echo lab: cannot write to "%root%\target"; Rasterlab is built there 1>&2
    exit /b 1
)
echo lab: building Rasterlab (the first time fetches its libraries and takes a few minutes); log: "%log%" 1>&2
type nul > "%state%\building"
rem A library of an earlier version must not stay on the class path; nor may one go while others run.
set "modules=app grader"
if "%parts%"=="tests" set "modules=tests"
for %%M in (%modules%) do if exist "%root%\%%M\target\lib" rmdir /s /q "%root%\%%M\target\lib"
set "JAVA_HOME=%home%"
call "%root%\mvnw.cmd" -B -f "%root%\pom.xml" -pl %parts% -am -Dmaven.test.skip=true package > "%log%" 2>&1 < nul
if not "%errorlevel%"=="0" (
    powershell -NoProfile -Command "$lines = @(Select-String -LiteralPath $env:log -Pattern '^\[ERROR\] ' | Select-Object -First 3 | ForEach-Object Line); if (-not $lines) { $lines = Get-Content -LiteralPath $env:log -Tail 3 }; $lines" 1>&2
    echo lab: the build failed; its whole log is in "%log%" 1>&2
    exit /b 1
)
move /y "%state%\building" "%stamp%" > nul
echo lab: built 1>&2

:run
set "module=app"
set "main=rasterlab.app.Main"
set "arguments=%*"
if "%command%"=="bench" (
    set "module=tests"
    set "main=rasterlab.tests.bench.Bench"
)
if "%command%"=="grader" (
    set "module=grader"
    set "main=rasterlab.grader.MainKt"
)
if not "%module%"=="app" for /f "tokens=1,* delims= " %%A in ("%*") do set "arguments=%%B"
if "%~1 %~2"=="help grader" for /f "tokens=2,* delims= " %%A in ("%*") do set "arguments=help %%B"
if defined language for /f "tokens=1-3,* delims== " %%A in ("%*") do set "arguments=%language% %%D"
set "native="
if %major% GEQ 24 set "native=--enable-native-access=ALL-UNNAMED"
rem The server's own heap, in MiB; whatever is no such number is left to the server, which refuses it.
set "memory="
if not "%module%"=="grader" goto start
set "heap=256"
set "named="
for %%A in (%arguments%) do (
    if defined named set "heap=%%~A"
    set "named="
    if "%%~A"=="--heap" set "named=yes"
)
if not defined heap set "heap=256"
for /f "delims=0123456789" %%D in ("%heap%") do set "heap=256"
if %heap% LSS 64 set "heap=256"
if %heap% GTR 65536 set "heap=256"
set "memory=-XX:+UseSerialGC -XX:TieredStopAtLevel=1 -Xmx%heap%m"
:start
set "options="
if "%module%"=="app" set options="@%root%\app\java-options"
set classes="%root%\%module%\target\classes;%root%\%module%\target\lib\*"
"%java%" %memory% %native% %options% -Dfile.encoding=UTF-8 "-Drasterlab.home=%root%" -cp %classes% %main% %arguments%
exit /b %errorlevel%

rem Errorlevel 1 when a source is newer than the last build, or there was none.
:stale
if not exist "%stamp%" exit /b 1
powershell -NoProfile -Command "$built = (Get-Item -LiteralPath $env:stamp).LastWriteTime; Set-Location -LiteralPath $env:root; if (Get-ChildItem pom.xml, */pom.xml, */src/main -Recurse | Where-Object { $_.LastWriteTime -gt $built } | Select-Object -First 1) { exit 1 }; exit 0"
exit /b %errorlevel%
