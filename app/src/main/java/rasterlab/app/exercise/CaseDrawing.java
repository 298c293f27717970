package rasterlab.app.exercise;

import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.imageio.ImageIO;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.PicturePart;

/**
 * A case's pictures, decoded: what is right, what was drawn, and where they differ.
 *
 * @param pixels that each of them shows, across and down
 * @param part which ones these are; empty where that is not known
 * @param rasters by their kinds
 */
record CaseDrawing(
        Dimension pixels, Optional<PicturePart> part, Map<String, RasterPicture> rasters) {
    static final List<String> KEYS = List.of("expected", "actual", "difference");

    /** Before there is a picture. */
    static final CaseDrawing NONE =
            new CaseDrawing(new Dimension(1, 1), Optional.empty(), Map.of());

    /**
     * What there is room for.
     *
     * @param place in the pictures, in their pixels
     * @param said which part it is; empty where it is all
     */
    record Cut(Rectangle place, Optional<PicturePart> said) {}

    /**
     * @throws IOException if they are no pictures, or of several sizes
     */
    static CaseDrawing of(List<CasePicture> from) throws IOException {
        var decoded = new LinkedHashMap<String, BufferedImage>();
        for (CasePicture one : from) decoded.put(one.kind(), decoded(one.png()));
        BufferedImage first = decoded.get(from.get(0).kind());
        for (BufferedImage other : decoded.values()) requireAlike(first, other);
        Dimension told = pixels(from.get(0).rows());
        int dots = dots(told, first);
        var pixels = dots > 0 ? told : new Dimension(first.getWidth(), first.getHeight());
        var rasters = new LinkedHashMap<String, RasterPicture>();
        decoded.forEach(
                (kind, picture) ->
                        rasters.put(kind, RasterPicture.of(picture, pixels, Math.max(1, dots))));
        return new CaseDrawing(
                pixels, from.get(0).part().filter(part -> isOf(part, pixels)), rasters);
    }

    /** Columns and rows. */
    static Dimension pixels(List<String> rows) {
        return new Dimension(rows.stream().mapToInt(String::length).max().orElse(0), rows.size());
    }

    private static boolean isOf(PicturePart part, Dimension pixels) {
        return part.shown().width() == pixels.width && part.shown().height() == pixels.height;
    }

    private static BufferedImage decoded(byte[] png) throws IOException {
        BufferedImage picture = ImageIO.read(new ByteArrayInputStream(png));
        if (picture == null) throw new IOException("a case's picture is no PNG");
        return picture;
    }

    private static void requireAlike(BufferedImage first, BufferedImage other) throws IOException {
        if (other.getWidth() == first.getWidth() && other.getHeight() == first.getHeight()) return;
        throw new IOException(
                "a case's pictures are of %d×%d and %d×%d pixels"
                        .formatted(
                                first.getWidth(),
                                first.getHeight(),
                                other.getWidth(),
                                other.getHeight()));
    }

    /** Dots of the picture for each pixel; 0 where it is no enlargement of these with a frame. */
    private static int dots(Dimension pixels, BufferedImage picture) {
        int dots = (picture.getWidth() - 1) / Math.max(1, pixels.width);
        boolean enlarged =
                picture.getWidth() == dots * pixels.width + 1
                        && picture.getHeight() == dots * pixels.height + 1;
        return enlarged ? dots : 0;
    }

    /** At most so many columns and rows around the pixel that the case's message names. */
    Cut cut(Dimension size) {
        if (part.isEmpty())
            return new Cut(
                    new Rectangle(
                            (pixels.width - size.width) / 2,
                            (pixels.height - size.height) / 2,
                            size.width,
                            size.height),
                    Optional.empty());
        PicturePart known = part.get();
        PicturePart seen = known.around(size.width, size.height);
        return new Cut(
                new Rectangle(
                        seen.shown().xmin() - known.shown().xmin(),
                        seen.shown().ymin() - known.shown().ymin(),
                        size.width,
                        size.height),
                Optional.of(seen).filter(each -> !each.isWhole()));
    }
}
