package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Component;
import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.Test;

/** Tabs in windows of several sizes, under a real display. */
class WindowSizesTest extends WindowHarness {
    @Test
    void stageFillsWhatTheWindowLeavesIt() {
        var faults = new ArrayList<String>();
        for (Dimension size : SIZES) {
            window.resizeTo(size);
            Stream.of("coordinates", "polygon", "clip", "visibility", "light")
                    .filter(tab -> !isStageLarge(tab))
                    .map(tab -> tab + " in " + size.width + "×" + size.height)
                    .forEach(faults::add);
        }
        assertEquals(List.of(), faults, "small pictures");
    }

    private boolean isStageLarge(String tab) {
        show(tab);
        Component stage = robot.finder().findByName(frame, "stage", true);
        return GuiActionRunner.execute(
                () ->
                        stage.getWidth() > frame.getWidth() / 3
                                && stage.getHeight() > frame.getHeight() / 2);
    }
}
