package rasterlab.engine.visibility.hidden;

import rasterlab.engine.raster.Raster;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.visibility.FacePaint;

/**
 * The number of the face in each pixel, row by row; {@link #NOTHING} where there is none: an output
 * of topic {@code hidden-surfaces}.
 *
 * @param width pixels of a row
 */
public record FacePicture(int width, int[] faces) {
    /** Stands for the background. */
    public static final int NOTHING = -1;

    public FacePicture {
        faces = faces.clone();
    }

    /** Paints the number of a face where others paint its colour. */
    static final FacePaint NUMBERS =
            (face, y, from, to, out) -> {
                int row = y * out.width();
                for (int x = from; x < to; x++) out.argb()[row + x] = face + 1;
            };

    /** The numbers that {@link #NUMBERS} left in a picture that was cleared to 0. */
    static FacePicture of(Raster raster) {
        int[] faces = raster.argb().clone();
        for (int i = 0; i < faces.length; i++) faces[i]--;
        return new FacePicture(raster.width(), faces);
    }

    public int height() {
        return faces.length / width;
    }

    /** The face at a pixel. */
    public int face(int x, int y) {
        return faces[y * width + x];
    }

    /** The share of pixels that show another face, in percent. */
    Deviation deviation(FacePicture actual) {
        long wrong = 0;
        String first = "";
        for (int i = 0; i < faces.length; i++) {
            if (faces[i] == actual.faces[i]) continue;
            if (wrong++ == 0)
                first =
                        "pixel (%d, %d) shows %s, not %s"
                                .formatted(
                                        i % width,
                                        i / width,
                                        named(actual.faces[i]),
                                        named(faces[i]));
        }
        double percent = 100.0 * wrong / faces.length;
        return new Deviation(percent, 0, wrong, faces.length, first);
    }

    private static String named(int face) {
        return face == NOTHING ? "nothing" : "face " + face;
    }

    @Override
    public String toString() {
        return width + "×" + height() + " pixels";
    }
}
