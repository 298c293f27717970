package rasterlab.app.exercise.outcome;

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
import rasterlab.app.language.Language;
import rasterlab.exercises.score.PicturePart;

/**
 * A case's pictures, decoded.
 *
 * @param pixels that each grid of pixels shows, across and down; where there is no grid, the shape
 *     of the place in which each picture has room
 * @param divisible whether that is a grid, of which a part can be shown
 * @param part which pixels these are; empty where that is not known
 * @param pictures by their kinds, in order
 */
public record CaseDrawing(
        Dimension pixels,
        boolean divisible,
        Optional<PicturePart> part,
        Map<String, PaintedPicture> pictures) {
    /** The drawing before there is a picture. */
    public static final CaseDrawing NONE =
            new CaseDrawing(new Dimension(1, 1), true, Optional.empty(), Map.of());

    /** Units along the longer side of a place without pixels: fine enough for its shape. */
    private static final int SIDE = 24;

    /**
     * The size that there is room for.
     *
     * @param place in the pictures, in their pixels
     * @param part which part it is; empty where it is all
     */
    public record PictureCrop(Rectangle place, Optional<PicturePart> part) {}

    /**
     * @param from at least one
     * @param language in which their numbers are written
     * @throws IOException if they are no pictures, or grids of several sizes
     */
    public static CaseDrawing of(List<ResultPicture> from, Language language) throws IOException {
        var decoded = new LinkedHashMap<String, BufferedImage>();
        for (ResultPicture one : from)
            decoded.put(one.kind(), decoded(one.file().in(language.locale().getLanguage())));
        List<ResultPicture> grids = from.stream().filter(one -> !one.rows().isEmpty()).toList();
        if (grids.isEmpty()) return ofShapes(decoded);
        BufferedImage first = decoded.get(grids.get(0).kind());
        for (ResultPicture grid : grids) requireAlike(first, decoded.get(grid.kind()));
        Dimension told = pixels(grids.get(0).rows());
        int dots = dots(told, first);
        var pixels = dots > 0 ? told : new Dimension(first.getWidth(), first.getHeight());
        var pictures = new LinkedHashMap<String, PaintedPicture>();
        decoded.forEach((kind, picture) -> pictures.put(kind, new FittedPicture(picture)));
        for (ResultPicture grid : grids)
            pictures.put(
                    grid.kind(),
                    RasterPicture.of(decoded.get(grid.kind()), pixels, Math.max(1, dots)));
        return new CaseDrawing(
                pixels, true, grids.get(0).part().filter(part -> isOf(part, pixels)), pictures);
    }

    /** A chart in the place of pictures. */
    public static CaseDrawing of(SpeedPicture chart) {
        return new CaseDrawing(
                SpeedPicture.SHAPE, false, Optional.empty(), Map.of(SpeedPicture.KIND, chart));
    }

    private static CaseDrawing ofShapes(Map<String, BufferedImage> decoded) {
        var pictures = new LinkedHashMap<String, PaintedPicture>();
        decoded.forEach((kind, picture) -> pictures.put(kind, new FittedPicture(picture)));
        int width = decoded.values().stream().mapToInt(BufferedImage::getWidth).max().orElseThrow();
        int height =
                decoded.values().stream().mapToInt(BufferedImage::getHeight).max().orElseThrow();
        double unit = (double) Math.max(width, height) / SIDE;
        var shape =
                new Dimension(
                        (int) Math.max(1, Math.round(width / unit)),
                        (int) Math.max(1, Math.round(height / unit)));
        return new CaseDrawing(shape, false, Optional.empty(), pictures);
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

    /**
     * The cut of at most so many columns and rows around the pixel that the case's message names.
     */
    public PictureCrop cut(Dimension size) {
        if (part.isEmpty())
            return new PictureCrop(
                    new Rectangle(
                            (pixels.width - size.width) / 2,
                            (pixels.height - size.height) / 2,
                            size.width,
                            size.height),
                    Optional.empty());
        PicturePart known = part.get();
        PicturePart seen = known.around(size.width, size.height);
        return new PictureCrop(
                new Rectangle(
                        seen.shown().xmin() - known.shown().xmin(),
                        seen.shown().ymin() - known.shown().ymin(),
                        size.width,
                        size.height),
                Optional.of(seen).filter(each -> !each.isWhole()));
    }
}
