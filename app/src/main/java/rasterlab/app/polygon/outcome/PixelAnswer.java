package rasterlab.app.polygon.outcome;

import java.util.List;
import java.util.Map;
import rasterlab.engine.polygon.scan.RowCrossing;
import rasterlab.engine.raster.PixelSet;

/**
 * The pixels that a method filled, run by run.
 *
 * @param runs in the method's order
 * @param missing exact pixels that were not filled
 * @param extra filled pixels that are not exact
 * @param crossings of each row that the method listed
 * @param reads pixels that were read, 0 where none has to be
 * @param writes pixels that were written, each as often as it was
 */
public record PixelAnswer(
        Runs runs,
        PixelSet missing,
        PixelSet extra,
        Map<Integer, List<RowCrossing>> crossings,
        long reads,
        long writes)
        implements PolygonAnswer {
    @Override
    public int steps() {
        return runs.size();
    }
}
