package rasterlab.app.canvas.lab;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import rasterlab.engine.fill.FillTask;
import rasterlab.engine.fill.FillTopic;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.transform.chain.Chain;
import rasterlab.engine.transform.chain.TransformTopic;
import rasterlab.engine.transform.rotate.RotateTopic;
import rasterlab.engine.transform.rotate.Turns;

class CommandInputTest {
    @Test
    void aSpaceStandsBehindCommasAndColonsAndNoneElsewhere() {
        var segment = new Segment(-1, 2, 7, 3).in(new PixelWindow(0, 0, 5, 6));
        assertEquals(
                "{\"from\": [-1, 2], \"to\": [7, 3], \"window\": [0, 0, 5, 6]}",
                CommandInput.of(new LineTopic().format(), segment));
    }

    @Test
    void wholeNumbersHaveNoFractionAndZerosNoSign() {
        var turns = new Turns(-0.0, 2, new double[] {1, 0.1, 1e21, -3});
        assertEquals(
                "{\"points\": [[1, 0.1], [1.0E21, -3]], \"degrees\": 0, \"times\": 2}",
                CommandInput.of(new RotateTopic().format(), turns));
    }

    @Test
    void whereOnePointIsAtInfinityAllSayTheirH() {
        var chain = new Chain(2, new double[0][], new double[] {1, 2, 3, 4}, new double[] {1, 0});
        assertEquals(
                "{\"matrices\": [], \"points\": [[1, 2, 1], [3, 4, 0]]}",
                CommandInput.of(new TransformTopic().format(), chain));
    }

    @Test
    void aQuotedColorStaysJson() {
        var task = new FillTask(List.of("\"\\", ".."), 0, 1, '"', 4);
        assertEquals(
                "{\"picture\": [\"\\\"\\\\\", \"..\"], \"seed\": [0, 1], \"with\": \"\\\"\","
                        + " \"connectivity\": 4}",
                CommandInput.of(new FillTopic().format(), task));
    }
}
