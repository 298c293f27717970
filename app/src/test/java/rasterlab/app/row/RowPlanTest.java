package rasterlab.app.row;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RowPlanTest {
    /** Sizes of the stage in windows of 900×600, 1280×800 and 1920×1080. */
    @ParameterizedTest(name = "pictures lie over the bands or out of the stage of {0}×{1}")
    @CsvSource({"520, 428", "900, 655", "1540, 960"})
    void picturesLieBesideTheBands(int width, int height) {
        var plan = new RowPlan(width, height, true);
        assertTrue(plan.column() >= 100, plan.column() + " wide");
        assertEquals(plan.columnLeft(), RowPlan.MARGIN + plan.wide() + RowPlan.MARGIN);
        assertEquals(width, plan.columnLeft() + plan.column() + RowPlan.MARGIN);
    }

    @ParameterizedTest(name = "a place of the bands is another pixel where pictures are {0}")
    @CsvSource({"true", "false"})
    void pixelsShareTheWidthOfTheBands(boolean pictured) {
        var plan = new RowPlan(900, 655, pictured);
        for (int pixel = 0; pixel < 16; pixel++) {
            double middle = RowPlan.MARGIN + plan.wide() * (pixel + 0.5) / 16;
            assertEquals(pixel, plan.pixelAt((int) middle, 16));
        }
        assertEquals(0, plan.pixelAt(-5, 16));
        assertEquals(15, plan.pixelAt(899, 16));
    }

    @Test
    void picturesTooSmallToShowAnythingLeaveTheStageToTheBands() {
        var plan = new RowPlan(900, 120, true);
        assertEquals(0, plan.column());
        assertEquals(860, plan.wide());
    }
}
