package rasterlab.engine.light.face;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

class MachBandsTest {
    @Test
    @DisplayName("Gouraud shows the whole highlight, or steps; flat does not step; Phong bends")
    void bandsAreStepsThenKinksThenNone() {
        BrightnessProfile flat = MachBands.profile("flat", 101);
        BrightnessProfile gouraud = MachBands.profile("gouraud", 101);
        BrightnessProfile phong = MachBands.profile("phong", 101);
        assertTrue(flat.largestStep() > 0.1, "flat steps by " + flat.largestStep());
        assertEquals(0, gouraud.largestStep(), 1e-12);
        assertEquals(0, phong.largestStep(), 1e-12);
        assertTrue(gouraud.largestKink() > 2 * phong.largestKink());
        assertTrue(brightest(gouraud) < brightest(phong) - 0.02, "the highlight is cut off");
    }

    private static double brightest(BrightnessProfile profile) {
        return Arrays.stream(profile.brightness()).max().orElseThrow();
    }
}
