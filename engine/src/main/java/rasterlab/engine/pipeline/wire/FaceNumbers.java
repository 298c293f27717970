package rasterlab.engine.pipeline.wire;

import java.util.Arrays;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.FacePaint;

/** Writes a face's number plus 1 instead of its colour; 0 is the background. */
final class FaceNumbers implements FacePaint {
    static final int BACKGROUND = 0;

    @Override
    public void span(int face, int y, int from, int to, Raster out) {
        int row = y * out.width();
        Arrays.fill(out.argb(), row + from, row + to, face + 1);
    }
}
