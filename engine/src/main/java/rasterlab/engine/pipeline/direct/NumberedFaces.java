package rasterlab.engine.pipeline.direct;

import java.util.Arrays;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import rasterlab.engine.pipeline.fast.Surface;
import rasterlab.engine.pipeline.fast.TrianglePipeline;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.Cancellation;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.Visibility;
import rasterlab.engine.visibility.VisibilityWork;

/**
 * The triangle pipeline as one visibility method among others: it draws the faces' numbers as
 * colours, and the paint then colours each pixel once, whatever was drawn over.
 */
public final class NumberedFaces implements Visibility {
    /** Faces have numbers from 1 in 24 bits; 0 is the background. */
    private static final int MOST_FACES = (1 << 24) - 1;

    @Override
    public VisibilityWork draw(
            ViewedMesh view, FacePaint paint, Raster out, BooleanSupplier cancelled) {
        require(view, paint);
        var space = new ClipSpace(view);
        if (space.empty()) return painted(0);
        var numbers = new Raster(out.width(), out.height());
        int[] faces = IntStream.range(0, view.mesh().faceCount()).toArray();
        int[] colors = IntStream.of(faces).map(face -> 0xFF000000 | face + 1).toArray();
        var packed = PackedFaces.apart(view.mesh(), faces);
        var surface = new Surface.Flat(new FaceTint(packed, colors));
        try (var pipeline = new TrianglePipeline()) {
            pipeline.drawOn(0, packed.triangles(), space.view(), surface, numbers, cancelled);
        }
        long pixels = 0;
        for (int y = 0; y < out.height(); y++) {
            Cancellation.check(cancelled);
            pixels += paintRow(numbers, y, paint, out);
        }
        return painted(pixels);
    }

    private static void require(ViewedMesh view, FacePaint paint) {
        int faces = view.mesh().faceCount();
        if (faces > MOST_FACES)
            throw new IllegalArgumentException(
                    "pipeline: at most %d faces can have numbers, got %d"
                            .formatted(MOST_FACES, faces));
        for (int face = 0; face < faces; face++)
            if (!paint.opaque(face))
                throw new IllegalArgumentException(
                        ("pipeline: face %d is transparent; with shading tone or a depth cue only"
                                        + " other methods, such as zfloat, mix it")
                                .formatted(face));
    }

    /** The pipeline does not count its depth tests. */
    private static VisibilityWork painted(long pixels) {
        return new VisibilityWork(0, 0, pixels, 0);
    }

    private static int paintRow(Raster numbers, int y, FacePaint paint, Raster out) {
        int row = y * out.width();
        int[] number = Arrays.copyOfRange(numbers.argb(), row, row + out.width());
        int painted = 0;
        for (int from = 0, to; from < number.length; from = to) {
            int face = (number[from] & 0xFFFFFF) - 1;
            to = from + 1;
            while (to < number.length && number[to] == number[from]) to++;
            if (face < 0) continue;
            paint.span(face, y, from, to, out);
            painted += to - from;
        }
        return painted;
    }
}
