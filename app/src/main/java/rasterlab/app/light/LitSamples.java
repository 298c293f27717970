package rasterlab.app.light;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntUnaryOperator;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.SeenPoint;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.hidden.Visibilities;

/**
 * Points of a picture, one for each square of pixels that shows something of a body.
 *
 * @param faces number of the face in each pixel, from 1; 0 where there is none
 * @param width pixels of a row
 * @param side pixels of a square's side
 * @param sample number of each square's point, row by row; −1 where it shows nothing
 * @param points one for each square with something in it
 */
record LitSamples(int[] faces, int width, int side, int[] sample, List<SeenPoint> points) {
    /** The finest squares. */
    private static final int FINEST = 3;

    private static final int COARSEST = 64;

    /**
     * @param most points
     */
    static LitSamples of(ViewedMesh view, int most) {
        int[] faces = faces(view);
        int width = view.fit().width();
        int side = FINEST;
        while (side < COARSEST && squares(faces, width, side) > most) side++;
        int across = (width + side - 1) / side;
        int down = (faces.length / width + side - 1) / side;
        var sample = new int[across * down];
        var points = new ArrayList<SeenPoint>();
        for (int square = 0; square < sample.length; square++) {
            int pixel = pixel(faces, width, side, square % across, square / across);
            sample[square] = pixel < 0 ? -1 : points.size();
            if (pixel >= 0)
                points.add(SeenPoint.of(view, faces[pixel] - 1, pixel % width, pixel / width));
        }
        return new LitSamples(faces, width, side, sample, List.copyOf(points));
    }

    private static int[] faces(ViewedMesh view) {
        var out = new Raster(view.fit().width(), view.fit().height());
        new Visibilities()
                .named("zfloat")
                .implementation()
                .draw(
                        view,
                        (face, y, from, to, into) -> {
                            int row = y * into.width();
                            for (int x = from; x < to; x++) into.argb()[row + x] = face + 1;
                        },
                        out,
                        () -> false);
        return out.argb();
    }

    private static int squares(int[] faces, int width, int side) {
        int across = (width + side - 1) / side;
        int down = (faces.length / width + side - 1) / side;
        int count = 0;
        for (int y = 0; y < down; y++)
            for (int x = 0; x < across; x++) if (pixel(faces, width, side, x, y) >= 0) count++;
        return count;
    }

    /** The pixel of a square whose point is taken: the middle one, or the first; −1 for none. */
    private static int pixel(int[] faces, int width, int side, int across, int down) {
        int left = across * side;
        int top = down * side;
        int height = faces.length / width;
        int middle =
                Math.min(height - 1, top + side / 2) * width + Math.min(width - 1, left + side / 2);
        if (faces[middle] > 0) return middle;
        for (int y = top; y < Math.min(height, top + side); y++)
            for (int x = left; x < Math.min(width, left + side); x++)
                if (faces[y * width + x] > 0) return y * width + x;
        return -1;
    }

    /** A picture of the body in which each square has the colour of its point. */
    Raster picture(int background, IntUnaryOperator color) {
        var out = new Raster(width, faces.length / width);
        out.clear(0xFF000000 | background);
        int across = (width + side - 1) / side;
        var colors = new int[points.size()];
        for (int k = 0; k < colors.length; k++) colors[k] = color.applyAsInt(k);
        for (int pixel = 0; pixel < faces.length; pixel++)
            if (faces[pixel] > 0) {
                int square = pixel / width / side * across + pixel % width / side;
                out.argb()[pixel] = colors[sample[square]];
            }
        return out;
    }
}
