<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en">
<context>
    <name>stromar::CRecorder</name>
    <message numerus="yes">
        <source>Recording cancelled: %1 of %n frame(s) are saved</source>
        <translation>
            <numerusform>Recording cancelled: %1 of %n frame is saved</numerusform>
            <numerusform>Recording cancelled: %1 of %n frames are saved</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Saved %n frame(s)</source>
        <translation>
            <numerusform>Saved %n frame</numerusform>
            <numerusform>Saved %n frames</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>stromar::CViewController</name>
    <message numerus="yes">
        <source>Split into %n path(s)</source>
        <translation>
            <numerusform>Split into %n path</numerusform>
            <numerusform>Split into %n paths</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Saved %n frame(s) of a turntable</source>
        <translation>
            <numerusform>Saved %n frame of a turntable</numerusform>
            <numerusform>Saved %n frames of a turntable</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Line %1 wrote %n segment(s)</source>
        <translation>
            <numerusform>Line %1 wrote %n segment</numerusform>
            <numerusform>Line %1 wrote %n segments</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>This point touches %n branch(es)</source>
        <translation>
            <numerusform>This point touches %n branch</numerusform>
            <numerusform>This point touches %n branches</numerusform>
        </translation>
    </message>
</context>
</TS>
