package rasterlab.app.exercise;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
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

    private record Shown(String key, BufferedImage picture) {}

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
            return List.of(
                    new Shown("expected", decoded(from.expected())),
                    new Shown("actual", decoded(from.actual())),
                    new Shown("difference", decoded(from.difference())));
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
        placed(seen.stream().map(Shown::key).toList())
                .ifPresent(
                        placed -> {
                            g.setFont(placed.type());
                            for (int i = 0; i < seen.size(); i++)
                                paint(g, seen.get(i), placed.places().get(i));
                        });
    }

    /** Whether all pictures have room for their names. */
    boolean together() {
        return placed(TOGETHER).isPresent();
    }

    /** Where those pictures stand now; empty where their names have no room. */
    Optional<NamedPictures> placed(List<String> keys) {
        Font type = getFont() == null ? UIManager.getFont("Label.font") : getFont();
        List<String> names = keys.stream().map(key -> texts.text("view." + key)).toList();
        int gap = UIScale.scale(GAP);
        // The frame's last line lies outside of its picture.
        var room = new Dimension(getWidth() - 1, getHeight() - 1);
        return new NamedPictures.Wanted(names, grid.pixels(), type, this::getFontMetrics, gap)
                .in(room);
    }

    /** One picture with a frame and its name. */
    private void paint(Graphics2D g, Shown one, Rectangle place) {
        int width = grid.dots() * grid.pixels().width;
        int height = grid.dots() * grid.pixels().height;
        g.setRenderingHint(
                RenderingHints.KEY_INTERPOLATION,
                place.width % width == 0
                        ? RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR
                        : RenderingHints.VALUE_INTERPOLATION_BICUBIC);
        int right = place.x + place.width;
        int bottom = place.y + place.height;
        g.drawImage(one.picture(), place.x, place.y, right, bottom, 0, 0, width, height, null);
        g.setColor(UIManager.getColor("Component.borderColor"));
        g.drawRect(place.x, place.y, place.width, place.height);
        g.setColor(UIManager.getColor("Label.foreground"));
        int base = bottom + NamedPictures.ABOVE_NAME + g.getFontMetrics().getAscent();
        g.drawString(texts.text("view." + one.key()), place.x, base);
    }
}
