package rasterlab.app.exercise;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import javax.accessibility.AccessibleRole;
import javax.imageio.ImageIO;
import javax.swing.Timer;
import javax.swing.UIManager;
import rasterlab.app.canvas.SelfDrawn;
import rasterlab.app.language.Texts;

/** A case's pictures, each with its name below: all in sight, alone, or in turn. */
final class CasePicture extends SelfDrawn {
    private static final long serialVersionUID = 1L;

    static final List<String> VIEWS =
            List.of("together", "expected", "actual", "difference", "blink");

    private static final List<String> TOGETHER = List.of("expected", "actual", "difference");

    /** As long as the eye needs to see what jumps. */
    private static final int BLINK_MILLIS = 450;

    private static final int GAP = 10;

    /**
     * Each pixel is at least so many view units wide, where the room has place for some of them.
     */
    private static final int CLEAR = 3;

    private record Shown(String key, BufferedImage picture) {}

    /**
     * @param part of the raster that is seen
     * @param words below, which part of what it is; empty where it is all
     */
    private record Placed(Rectangle part, NamedPictures pictures, Optional<String> words) {}

    /**
     * @param pixels that the pictures show, across and down
     * @param dots of the pictures for each of these pixels
     */
    private record Grid(Dimension pixels, int dots) {
        /** The picture's own pixels where it is no enlargement of the others with a frame. */
        static Grid of(Dimension pixels, BufferedImage picture) {
            int width = picture.getWidth();
            int height = picture.getHeight();
            int dots = (width - 1) / Math.max(1, pixels.width);
            boolean enlarged =
                    dots > 0
                            && width == dots * pixels.width + 1
                            && height == dots * pixels.height + 1;
            return enlarged ? new Grid(pixels, dots) : new Grid(new Dimension(width, height), 1);
        }
    }

    private final transient Texts texts;
    private final transient Consumer<Throwable> onFailure;
    private final Timer blink = new Timer(BLINK_MILLIS, e -> turn());
    private transient Optional<TriedCase.Pictures> pictures = Optional.empty();
    private transient List<Shown> decoded = List.of();
    private transient Map<String, RasterPicture> rasters = Map.of();
    private transient Grid grid = new Grid(new Dimension(1, 1), 1);
    private String view = VIEWS.get(0);
    private boolean second;

    /**
     * @param onFailure told of a picture that cannot be read
     */
    CasePicture(Texts texts, Consumer<Throwable> onFailure) {
        super(AccessibleRole.CANVAS);
        this.texts = texts;
        this.onFailure = onFailure;
        setName("case.picture");
        getAccessibleContext().setAccessibleName(texts.text("case.picture"));
    }

    void show(Optional<TriedCase.Pictures> next) {
        if (!next.equals(pictures)) {
            pictures = next;
            decoded = next.map(this::decoded).orElse(List.of());
            if (!decoded.isEmpty())
                grid = Grid.of(next.orElseThrow().pixels(), decoded.get(0).picture());
            rasters =
                    decoded.stream()
                            .collect(
                                    Collectors.toMap(
                                            Shown::key,
                                            one ->
                                                    RasterPicture.of(
                                                            one.picture(),
                                                            grid.pixels(),
                                                            grid.dots())));
            next.ifPresent(drawn -> getAccessibleContext().setAccessibleDescription(drawn.text()));
        }
        repaint();
    }

    /**
     * @param next one of {@link #VIEWS}
     */
    void choose(String next) {
        view = next;
        second = false;
        if (view.equals("blink")) blink.start();
        else blink.stop();
        repaint();
    }

    /** Which picture is seen just now, where it is one. */
    String seen() {
        if (!view.equals("blink")) return view;
        return second ? "actual" : "expected";
    }

    /** Stops blinking. */
    void close() {
        blink.stop();
    }

    private void turn() {
        second = !second;
        repaint();
    }

    private List<Shown> decoded(TriedCase.Pictures from) {
        try {
            BufferedImage expected = decoded(from.expected());
            return List.of(
                    new Shown("expected", expected),
                    new Shown("actual", alike(decoded(from.actual()), expected)),
                    new Shown("difference", alike(decoded(from.difference()), expected)));
        } catch (IOException e) {
            onFailure.accept(e);
            return List.of();
        }
    }

    private static BufferedImage decoded(byte[] png) throws IOException {
        BufferedImage picture = ImageIO.read(new ByteArrayInputStream(png));
        if (picture == null) throw new IOException("a case's picture is no PNG");
        return picture;
    }

    private static BufferedImage alike(BufferedImage picture, BufferedImage first)
            throws IOException {
        if (picture.getWidth() == first.getWidth() && picture.getHeight() == first.getHeight())
            return picture;
        throw new IOException(
                "a case's pictures are of %d×%d and %d×%d pixels"
                        .formatted(
                                first.getWidth(),
                                first.getHeight(),
                                picture.getWidth(),
                                picture.getHeight()));
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(UIScale.scale(120), UIScale.scale(80));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        var g = (Graphics2D) graphics.create();
        g.setRenderingHint(
                RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        if (!decoded.isEmpty()) paintPictures(g);
        g.dispose();
    }

    private void paintPictures(Graphics2D g) {
        String alone = view.equals("together") && !together() ? "difference" : seen();
        List<Shown> seen =
                alone.equals("together")
                        ? decoded
                        : decoded.stream().filter(one -> one.key().equals(alone)).toList();
        parted(seen.stream().map(Shown::key).toList())
                .ifPresent(
                        placed -> {
                            g.setFont(placed.pictures().type());
                            for (int i = 0; i < seen.size(); i++)
                                paint(
                                        g,
                                        seen.get(i).key(),
                                        placed.part(),
                                        placed.pictures().places().get(i));
                            placed.words().ifPresent(said -> write(g, said, placed.pictures()));
                        });
    }

    /** Below the pictures and their names, smaller where it would be cut. */
    private void write(Graphics2D g, String said, NamedPictures above) {
        int lowest =
                above.places().stream()
                        .mapToInt(place -> place.y + place.height)
                        .max()
                        .orElseThrow();
        int top = lowest + NamedPictures.ABOVE_NAME + g.getFontMetrics().getHeight();
        g.setFont(type());
        int wide = g.getFontMetrics().stringWidth(said);
        if (wide > getWidth()) g.setFont(type().deriveFont(type().getSize2D() * getWidth() / wide));
        g.drawString(said, 0, top + NamedPictures.ABOVE_NAME + g.getFontMetrics().getAscent());
    }

    /** Whether all pictures have room for their names. */
    boolean together() {
        return placed(TOGETHER).isPresent();
    }

    /** Where those pictures stand now; empty where their names have no room. */
    Optional<NamedPictures> placed(List<String> keys) {
        return parted(keys).map(Placed::pictures);
    }

    private Optional<Placed> parted(List<String> keys) {
        int words = getFontMetrics(type()).getHeight() + NamedPictures.ABOVE_NAME;
        return parted(keys, getHeight() - 1)
                .filter(placed -> part(placed.part().getSize()).isEmpty())
                .or(() -> parted(keys, getHeight() - 1 - words));
    }

    /** What is said of the part that is seen; "" where it is all. */
    String words() {
        return parted(TOGETHER).flatMap(Placed::words).orElse("");
    }

    /** Which part of the picture that is of what size; empty where it is all of it. */
    private Optional<String> part(Dimension shown) {
        Dimension kept = grid.pixels();
        List<Long> whole =
                pictures.filter(one -> one.pixels().equals(kept))
                        .map(TriedCase.Pictures::whole)
                        .orElse(List.of((long) kept.width, (long) kept.height));
        return shown.width == whole.get(0) && shown.height == whole.get(1)
                ? Optional.empty()
                : Optional.of(
                        texts.text(
                                "case.part",
                                shown.width,
                                shown.height,
                                whole.get(0),
                                whole.get(1)));
    }

    private Font type() {
        return getFont() == null ? UIManager.getFont("Label.font") : getFont();
    }

    private Optional<Placed> parted(List<String> keys, int height) {
        Font type = type();
        List<String> names = keys.stream().map(key -> texts.text("view." + key)).toList();
        int gap = UIScale.scale(GAP);
        // The frame's last line lies outside of its picture.
        var room = new Dimension(getWidth() - 1, height);
        var whole = new NamedPictures.Wanted(names, grid.pixels(), type, this::getFontMetrics, gap);
        Rectangle part = around(whole.part(CLEAR, room));
        return whole.of(part.getSize())
                .in(room)
                .map(placed -> new Placed(part, placed, part(part.getSize())));
    }

    /** A part of the raster of that size, with the first mark in its middle where it can. */
    private Rectangle around(Dimension part) {
        Dimension all = grid.pixels();
        Point centre =
                Optional.ofNullable(rasters.get("difference"))
                        .map(RasterPicture::firstMark)
                        .orElse(new Point());
        int left = Math.min(all.width - part.width, Math.max(0, centre.x - part.width / 2));
        int top = Math.min(all.height - part.height, Math.max(0, centre.y - part.height / 2));
        return new Rectangle(left, top, part.width, part.height);
    }

    /** One picture with a frame and its name. */
    private void paint(Graphics2D g, String key, Rectangle part, Rectangle place) {
        rasters.get(key).paint(g, part, place);
        g.setColor(UIManager.getColor("Component.borderColor"));
        g.drawRect(place.x, place.y, place.width, place.height);
        g.setColor(UIManager.getColor("Label.foreground"));
        int base =
                place.y + place.height + NamedPictures.ABOVE_NAME + g.getFontMetrics().getAscent();
        g.drawString(texts.text("view." + key), place.x, base);
    }
}
