package rasterlab.app.exercise;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
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
import rasterlab.app.canvas.LargeType;
import rasterlab.app.canvas.PictureType;
import rasterlab.app.canvas.SelfDrawn;
import rasterlab.app.language.Texts;

/** A case's pictures, each with its name below: side by side, alone, or in turn. */
final class CasePicture extends SelfDrawn {
    private static final long serialVersionUID = 1L;

    static final List<String> VIEWS =
            List.of("together", "expected", "actual", "difference", "blink");

    private static final List<String> TOGETHER = List.of("expected", "actual", "difference");

    /** Of the usual type. */
    private static final float SMALLER = 0.85f;

    /** As long as the eye needs to see what jumps. */
    private static final int BLINK_MILLIS = 450;

    private static final int GAP = 6;

    private record Shown(String key, BufferedImage picture) {}

    private final transient Texts texts;
    private final transient Consumer<Throwable> onFailure;
    private final Timer blink = new Timer(BLINK_MILLIS, e -> turn());
    private transient Optional<TriedCase.Pictures> pictures = Optional.empty();
    private transient List<Shown> decoded = List.of();
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
        int gap = UIScale.scale(GAP);
        g.setFont(typeOfNames());
        String alone = view.equals("together") && !together() ? "difference" : seen();
        List<Shown> seen =
                alone.equals("together")
                        ? decoded
                        : decoded.stream().filter(one -> one.key().equals(alone)).toList();
        int width = (getWidth() - gap * (seen.size() - 1)) / seen.size();
        for (int i = 0; i < seen.size(); i++) paint(g, seen.get(i), i * (width + gap), width);
    }

    /** Whether all pictures have room for their names beside each other. */
    boolean together() {
        return fit(typeOfNames());
    }

    /** Smaller than usual where all names have room by that only. */
    private Font typeOfNames() {
        if (LargeType.now() && getFont() != null && fit(getFont())) return getFont();
        Font usual = PictureType.in(getSize());
        Font smaller = usual.deriveFont(SMALLER * usual.getSize2D());
        return !fit(usual) && fit(smaller) ? smaller : usual;
    }

    private boolean fit(Font font) {
        FontMetrics metrics = getFontMetrics(font);
        int gap = UIScale.scale(GAP);
        int width = (getWidth() - gap * (TOGETHER.size() - 1)) / TOGETHER.size();
        return TOGETHER.stream()
                .allMatch(key -> metrics.stringWidth(texts.text("view." + key)) <= width);
    }

    /** One picture at the top of its column, with a frame and its name. */
    private void paint(Graphics2D g, Shown one, int left, int room) {
        FontMetrics metrics = g.getFontMetrics();
        int height = getHeight() - metrics.getHeight() - 2;
        double scale =
                Math.min(
                        (double) room / one.picture().getWidth(),
                        (double) height / one.picture().getHeight());
        int w = Math.max(1, (int) (one.picture().getWidth() * scale));
        int h = Math.max(1, (int) (one.picture().getHeight() * scale));
        g.setRenderingHint(
                RenderingHints.KEY_INTERPOLATION,
                scale < 1
                        ? RenderingHints.VALUE_INTERPOLATION_BICUBIC
                        : RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
        g.drawImage(one.picture(), left, 0, w, h, null);
        Color line = UIManager.getColor("Component.borderColor");
        g.setColor(line);
        g.drawRect(left, 0, w - 1, h - 1);
        g.setColor(UIManager.getColor("Label.foreground"));
        g.drawString(texts.text("view." + one.key()), left, h + metrics.getAscent() + 2);
    }
}
