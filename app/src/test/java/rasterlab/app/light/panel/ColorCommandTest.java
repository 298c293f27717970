package rasterlab.app.light.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import rasterlab.app.light.ColorChoice;
import rasterlab.contract.ColorModel;

class ColorCommandTest {
    @Test
    void commandHasTheColorAsItWasWritten() {
        assertEquals(
                "echo '{\"rgb\": [0.85, 0.45, 0.2]}' | ./lab run color formula",
                ColorCommand.of(ColorChoice.first()));
        ColorChoice hue = ColorChoice.first().with(ColorModel.HSV, 0, 210);
        String command = ColorCommand.of(hue.withMethod("eight-bit"));
        assertEquals(
                "echo '{\"hsv\": [210, "
                        + hue.components().get(1)
                        + ", "
                        + hue.components().get(2)
                        + "]}' | ./lab run color eight-bit",
                command);
    }
}
