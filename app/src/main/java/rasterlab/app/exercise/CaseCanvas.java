package rasterlab.app.exercise;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.accessibility.AccessibleRole;
import javax.swing.Timer;
import javax.swing.UIManager;
import rasterlab.app.canvas.SelfDrawn;
import rasterlab.app.language.Texts;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.PicturePart;

/** A case's pictures, each with its name below: all in sight, alone, or in turn. */
final class CaseCanvas extends SelfDrawn {
    private static final long serialVersionUID = 1L;

    static final List<String> VIEWS =
            List.of("together", "expected", "actual", "difference", "blink");

    /** As long as the eye needs to see what jumps. */
    private static final int BLINK_MILLIS = 450;

    private static final int GAP = 10;

    private final transient Texts texts;
    private final transient Consumer<Throwable> onFailure;
    private final Timer blink = new Timer(BLINK_MILLIS, e -> turn());
    private transient List<CasePicture> pictures = List.of();
    private transient CaseDrawing drawing = CaseDrawing.NONE;
    private String view = VIEWS.get(0);
    private boolean second;

    /**
     * @param onFailure told of a picture that cannot be read
     */
    CaseCanvas(Texts texts, Consumer<Throwable> onFailure) {
        super(AccessibleRole.CANVAS);
        this.texts = texts;
        this.onFailure = onFailure;
        setName("case.picture");
        getAccessibleContext().setAccessibleName(texts.text("case.picture"));
    }

    void show(List<CasePicture> next) {
        if (!next.equals(pictures)) {
            pictures = next;
            drawing = next.isEmpty() ? CaseDrawing.NONE : decoded(next);
            CasePicture.of(next, CasePicture.DIFFERENCE)
                    .ifPresent(
                            drawn ->
                                    getAccessibleContext()
                                            .setAccessibleDescription(inWords(drawn)));
        }
        repaint();
    }

    private String inWords(CasePicture drawn) {
        Stream<String> rows = drawn.rows().stream();
        Optional<PicturePart> cut = drawn.part().filter(part -> !part.isWhole());
        return Stream.concat(cut.map(this::said).stream(), rows).collect(Collectors.joining("\n"));
    }

    private String said(PicturePart part) {
        String place = part.said().in(texts.locale().getLanguage()).replace('-', '−');
        return texts.text("case.part", place);
    }

    private CaseDrawing decoded(List<CasePicture> from) {
        try {
            return CaseDrawing.of(from);
        } catch (IOException e) {
            onFailure.accept(e);
            return CaseDrawing.NONE;
        }
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

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(UIScale.scale(120), UIScale.scale(80));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        var g = (Graphics2D) graphics.create();
        g.setRenderingHint(
                RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        if (!drawing.rasters().isEmpty()) paint(g);
        g.dispose();
    }

    private void paint(Graphics2D g) {
        String alone = view.equals("together") && !together() ? "difference" : seen();
        List<String> keys = alone.equals("together") ? CaseDrawing.KEYS : List.of(alone);
        Optional<PlacedCase> found = arranged(keys);
        if (found.isEmpty()) return;
        PlacedCase placed = found.get();
        g.setFont(placed.pictures().type());
        for (int i = 0; i < keys.size(); i++) {
            Rectangle place = placed.pictures().places().get(i);
            drawing.rasters().get(keys.get(i)).paint(g, placed.part(), place);
            frame(g, place, texts.text("view." + keys.get(i)));
        }
        write(g, placed);
    }

    private static void frame(Graphics2D g, Rectangle place, String name) {
        g.setColor(UIManager.getColor("Component.borderColor"));
        g.drawRect(place.x, place.y, place.width, place.height);
        g.setColor(UIManager.getColor("Label.foreground"));
        int base =
                place.y + place.height + NamedPictures.ABOVE_NAME + g.getFontMetrics().getAscent();
        g.drawString(name, place.x, base);
    }

    /** Below the pictures and their names, which part of them is seen. */
    private void write(Graphics2D g, PlacedCase placed) {
        int lowest =
                placed.pictures().places().stream()
                        .mapToInt(place -> place.y + place.height)
                        .max()
                        .orElseThrow();
        int top = lowest + 2 * NamedPictures.ABOVE_NAME + g.getFontMetrics().getHeight();
        g.setFont(type());
        int base = top + g.getFontMetrics().getAscent();
        for (int line = 0; line < placed.words().size(); line++)
            g.drawString(placed.words().get(line), 0, base + line * g.getFontMetrics().getHeight());
    }

    /** Whether all pictures have room for their names. */
    boolean together() {
        return arranged(CaseDrawing.KEYS).isPresent();
    }

    /** Where those pictures stand now; empty where their names have no room. */
    Optional<PlacedCase> arranged(List<String> keys) {
        Font type = type();
        List<String> names = keys.stream().map(key -> texts.text("view." + key)).toList();
        // The frame's last line lies outside of its picture.
        var room = new Dimension(getWidth() - 1, getHeight() - 1);
        var whole =
                new NamedPictures.Wanted(
                        names, drawing.pixels(), type, this::getFontMetrics, UIScale.scale(GAP));
        return new PlacedCase.Wanted(drawing, whole, this::said).in(room);
    }

    private Font type() {
        return getFont() == null ? UIManager.getFont("Label.font") : getFont();
    }
}
