package rasterlab.app.exercise.panel;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.accessibility.AccessibleRole;
import javax.swing.Timer;
import javax.swing.UIManager;
import rasterlab.app.canvas.SelfDrawn;
import rasterlab.app.exercise.outcome.CaseDrawing;
import rasterlab.app.exercise.outcome.ResultPicture;
import rasterlab.app.exercise.outcome.SpeedPicture;
import rasterlab.app.language.Texts;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.PicturePart;

/** A case's pictures, each with its name below: all in sight, alone, or in turn. */
public final class CaseCanvas extends SelfDrawn {
    private static final long serialVersionUID = 1L;

    /** The pictures that most cases have, and that are offered before there is one. */
    public static final List<String> USUAL =
            List.of(CasePicture.EXPECTED, CasePicture.ACTUAL, CasePicture.DIFFERENCE);

    private static final String TOGETHER = "together";
    private static final String BLINK = "blink";

    /** The time that the eye needs to see what jumps. */
    private static final int BLINK_MILLIS = 450;

    private static final int GAP = 10;

    private final transient Texts texts;
    private final transient Consumer<Throwable> onFailure;
    private final transient CaseZoom zoom = new CaseZoom(this);
    private final Timer blink = new Timer(BLINK_MILLIS, e -> turn());
    private transient List<ResultPicture> pictures = List.of();
    private transient CaseDrawing drawing = CaseDrawing.NONE;
    private transient Optional<SpeedPicture> chart = Optional.empty();

    /** The user's choice, which a case may not have. */
    private String wish = TOGETHER;

    /** The choice before blinking. */
    private String steady = TOGETHER;

    private boolean second;

    /**
     * @param onFailure told of a picture that cannot be read
     */
    public CaseCanvas(Texts texts, Consumer<Throwable> onFailure) {
        super(AccessibleRole.CANVAS);
        this.texts = texts;
        this.onFailure = onFailure;
        setName("case.picture");
        getAccessibleContext().setAccessibleName(texts.text("case.picture"));
    }

    public void show(List<ResultPicture> next) {
        if (!next.equals(pictures) || chart.isPresent()) {
            pictures = next;
            chart = Optional.empty();
            zoom.reset();
            drawing = next.isEmpty() ? CaseDrawing.NONE : decoded(next);
            if (!next.isEmpty()) getAccessibleContext().setAccessibleDescription(inWords());
            blinkWhereChosen();
        }
        repaint();
    }

    /** Shows a chart in the place of pictures. */
    public void show(SpeedPicture next) {
        if (chart.filter(one -> one == next).isPresent()) return;
        show(List.of());
        chart = Optional.of(next);
        zoom.reset();
        drawing = CaseDrawing.of(next);
        getAccessibleContext().setAccessibleDescription(next.inWords());
        repaint();
    }

    /** The text for people who do not see; of grids the difference tells all of them. */
    private String inWords() {
        return pictures.stream()
                .filter(one -> one.rows().isEmpty() || one.isDifference())
                .flatMap(this::inWords)
                .collect(Collectors.joining("\n"));
    }

    private Stream<String> inWords(ResultPicture drawn) {
        List<String> rows = drawn.rows();
        if (rows.isEmpty())
            return Stream.of(nameOf(drawn.kind()) + ": " + drawn.text().in(texts.language()));
        Optional<PicturePart> cut = drawn.part().filter(part -> !part.isWhole());
        return Stream.concat(cut.map(this::partText).stream(), rows.stream());
    }

    private String partText(PicturePart part) {
        String place = part.message().in(texts.locale().getLanguage());
        return texts.text("case.part", place);
    }

    private CaseDrawing decoded(List<ResultPicture> from) {
        try {
            return CaseDrawing.of(from, texts.language());
        } catch (IOException e) {
            onFailure.accept(e);
            return CaseDrawing.NONE;
        }
    }

    /** The views that the shown pictures allow. */
    public List<String> views() {
        List<String> kinds = kinds();
        var views = new ArrayList<String>(List.of(TOGETHER));
        views.addAll(kinds);
        if (kinds.containsAll(List.of(CasePicture.EXPECTED, CasePicture.ACTUAL))) views.add(BLINK);
        return List.copyOf(views);
    }

    /** The choice; where these pictures do not allow it, all of them together. */
    String view() {
        return views().contains(wish) ? wish : TOGETHER;
    }

    /** A view in words; a kind of picture that is not known under its own name. */
    public String nameOf(String view) {
        String key = "view." + view;
        return texts.has(key) ? texts.text(key) : view;
    }

    private List<String> kinds() {
        return drawing.pictures().isEmpty() ? USUAL : List.copyOf(drawing.pictures().keySet());
    }

    /**
     * @param next one of {@link #views}
     */
    void choose(String next) {
        wish = next;
        second = false;
        blinkWhereChosen();
        repaint();
    }

    /** Begins to blink; goes back to what was seen before where it blinks already. */
    void toggleBlink() {
        if (!views().contains(BLINK)) return;
        if (!view().equals(BLINK)) steady = view();
        choose(view().equals(BLINK) ? steady : BLINK);
    }

    private void blinkWhereChosen() {
        if (!view().equals(BLINK)) blink.stop();
        else if (!blink.isRunning()) blink.start();
    }

    /** Which picture is seen just now, where it is one. */
    public String seen() {
        if (!view().equals(BLINK)) return view();
        return second ? CasePicture.ACTUAL : CasePicture.EXPECTED;
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
        g.transform(zoom.transform());
        if (!drawing.pictures().isEmpty()) paint(g);
        g.dispose();
    }

    private void paint(Graphics2D g) {
        List<String> keys = shown();
        Optional<PlacedCase> found = arranged(keys);
        if (found.isEmpty()) return;
        PlacedCase placed = found.get();
        g.setFont(placed.pictures().type());
        for (int i = 0; i < keys.size(); i++) {
            Rectangle place = placed.pictures().places().get(i);
            drawing.pictures().get(keys.get(i)).paint(g, placed.part(), place);
            frame(g, place, nameOf(keys.get(i)));
        }
        write(g, placed);
    }

    /** Where there is no room for all, the one that tells most. */
    private List<String> shown() {
        if (!view().equals(TOGETHER)) return List.of(seen());
        List<String> kinds = kinds();
        if (together()) return kinds;
        return List.of(
                kinds.contains(CasePicture.DIFFERENCE) ? CasePicture.DIFFERENCE : kinds.get(0));
    }

    private static void frame(Graphics2D g, Rectangle place, String name) {
        g.setColor(UIManager.getColor("Component.borderColor"));
        g.drawRect(place.x, place.y, place.width, place.height);
        g.setColor(UIManager.getColor("Label.foreground"));
        int base =
                place.y + place.height + NamedPictures.ABOVE_NAME + g.getFontMetrics().getAscent();
        g.drawString(name, place.x, base);
    }

    /** Writes below the pictures and their names which part of them is seen. */
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
    public boolean together() {
        return arranged(kinds()).isPresent();
    }

    /** Where those pictures stand now; empty where their names have no room. */
    public Optional<PlacedCase> arranged(List<String> keys) {
        Font type = type();
        List<String> names = keys.stream().map(this::nameOf).toList();
        // The frame's last line lies outside of its picture.
        var room = new Dimension(getWidth() - 1, getHeight() - 1);
        var whole =
                new NamedPictures.PicturesToPlace(
                        names, drawing.pixels(), type, this::getFontMetrics, UIScale.scale(GAP));
        return new PlacedCase.CaseToPlace(drawing, whole, this::partText).in(room);
    }

    private Font type() {
        return getFont() == null ? UIManager.getFont("Label.font") : getFont();
    }
}
