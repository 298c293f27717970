package rasterlab.app.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;
import javax.swing.JComponent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.Plotted;

/** Shows what a program of the user's drew, beside the right line. */
@Timeout(300)
class TrialSegmentTest {
    private static final Segment SHORT = new Segment(0, 0, 2, 0);
    private static final Segment LONG = new Segment(0, 0, 9_999, 0);

    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final LineLabModel model = new LineLabModel(new LineTopic(), thread, failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    /** Shows the program's pixels beside the right line and waits until they are drawn. */
    private LineDrawings tried(Segment segment, Optional<Plotted> drawn) {
        model.showTried(segment, "bresenham", drawn);
        return settled();
    }

    private LineDrawings settled() {
        thread.settle(model::settle);
        return model.state().drawings();
    }

    private static Optional<Plotted> all(int... xy) {
        var pixels = new PixelRecording(9);
        for (int i = 0; i < xy.length; i += 2) pixels.plot(xy[i], xy[i + 1]);
        return Optional.of(new Plotted(pixels, false));
    }

    /** The first pixels of the row 0. */
    private static Optional<Plotted> first(int count) {
        var pixels = new PixelRecording(count);
        for (int x = 0; x < count; x++) pixels.plot(x, 0);
        return Optional.of(new Plotted(pixels, true));
    }

    @Test
    void programsPixelsStandBesideTheRightOnesOfTheirSegmentAlone() {
        LineDrawings shown = tried(SHORT, all(0, 0, 1, 1));
        LineDrawing program = shown.other().orElseThrow();
        assertEquals(2, program.difference().missing().size());
        assertEquals(1, program.difference().extra().size());
        assertEquals(0, shown.drawing().difference().missing().size());
        PixelDifference apart = shown.apart().orElseThrow();
        assertEquals(2, apart.extra().size(), "of the right line alone");
        assertEquals(1, apart.missing().size(), "of the program alone");
        model.moveEnd(End.B, 3, 0);
        assertTrue(settled().other().isEmpty(), "pixels of another segment");
        model.history().undo();
        assertTrue(settled().other().isPresent());
        model.chooseMethod("naive-textbook");
        assertTrue(settled().other().isEmpty(), "pixels beside a line that is not right");
        model.chooseMethod("bresenham");
        model.compareWith("dda");
        assertEquals("dda", settled().other().orElseThrow().method());
        model.show(SHORT);
        model.compareWith("");
        assertTrue(settled().other().isEmpty(), "pixels of an earlier case");
    }

    @Test
    void undoTakesTheProgramsPixelsBackWithTheirSegment() {
        LineChoice before = model.state().choice();
        tried(SHORT, all(0, 0, 1, 1));
        model.history().undo();
        assertEquals(before, settled().choice(), "one step");
        model.show(SHORT);
        assertTrue(settled().tried().isEmpty(), "pixels that were taken back");
        model.history().undo();
        tried(SHORT, all(0, 0, 1, 1));
        tried(SHORT, all(0, 0));
        model.history().undo();
        assertEquals(2, settled().other().orElseThrow().pixels(), "those of the case before");
        model.history().redo();
        assertEquals(1, settled().other().orElseThrow().pixels(), "those of the later case");
        model.show(SHORT);
        assertTrue(settled().tried().isEmpty());
        model.history().undo();
        assertEquals(1, settled().other().orElseThrow().pixels(), "those that were let go");
    }

    @Test
    void programsPixelsComeBackWithTheirSegment() {
        LineDrawings left = tried(SHORT, all(0, 0, 1, 1));
        try (var opened = new LineLabModel(new LineTopic(), thread, failures::add)) {
            opened.restore(model.kept());
            opened.keptTried().restore(model.keptTried().kept());
            thread.settle(opened::settle);
            LineDrawings shown = opened.state().drawings();
            assertEquals(left.choice(), shown.choice());
            assertEquals(2, shown.other().orElseThrow().pixels());
            assertEquals(1, shown.apart().orElseThrow().missing().size());
            assertFalse(opened.history().undoable());
        }
    }

    @ParameterizedTest(name = "nothing to draw becomes an empty drawing, or none: {0} pixels")
    @ValueSource(ints = {-1, 0, 1})
    void whatIsKeptIsWhatWasTried(int pixels) {
        var tried =
                new TrialSegment(
                        LONG, "dda", Optional.of(pixels).filter(n -> n >= 0).map(n -> plotted(n)));
        TrialSegment back = SavedTrial.of(Optional.of(tried)).tried().orElseThrow();
        assertEquals(
                tried.drawn().map(drawn -> drawn.pixels().size()),
                back.drawn().map(drawn -> drawn.pixels().size()));
        assertEquals(tried.segment(), back.segment());
        assertEquals(tried.right(), back.right());
        assertTrue(SavedTrial.of(Optional.empty()).tried().isEmpty());
    }

    @Test
    @DisplayName("millions of pixels are written at each start, or those left out count as missing")
    void ofManyPixelsTheFirstAreKept() {
        var tried = new TrialSegment(LONG, "dda", Optional.of(plotted(SavedTrial.MOST + 1)));
        TrialSegment back = SavedTrial.of(Optional.of(tried)).tried().orElseThrow();
        assertEquals(OptionalInt.of(SavedTrial.MOST), back.first());
    }

    private static Plotted plotted(int count) {
        var pixels = new PixelRecording(Math.max(1, count));
        for (int x = 0; x < count; x++) pixels.plot(x, 0);
        return new Plotted(pixels, false);
    }

    @ParameterizedTest(name = "nobody says whose line is seen: {0}")
    @EnumSource(Language.class)
    void stageSaysWhoseLineIsSeen(Language language) {
        Texts texts = Texts.of("line", language);
        var programs = List.of(all(0, 0), all(), Optional.<Plotted>empty());
        var said = new HashSet<String>();
        for (Optional<Plotted> drawn : programs) {
            String note = LineNotes.about(tried(SHORT, drawn), texts).orElseThrow();
            assertTrue(note.contains("bresenham"), note);
            said.add(note);
            String ofLong = LineNotes.about(tried(LONG, drawn), texts).orElseThrow();
            assertTrue(ofLong.endsWith(note), "not beside the note of a line that is cut");
            assertFalse(ofLong.equals(note), "the line is not said to be cut");
        }
        assertEquals(programs.size(), said.size(), said.toString());
        model.show(SHORT);
        assertEquals(Optional.empty(), LineNotes.about(settled(), texts));
    }

    @ParameterizedTest(name = "pixels after the cut are missed in the program: {0}")
    @EnumSource(Language.class)
    void ofACutProgramTheFirstPixelsAreCompared(Language language) {
        LineDrawings shown = tried(LONG, first(4000));
        assertEquals(0, shown.other().orElseThrow().difference().missing().size());
        assertTrue(shown.apart().orElseThrow().isEmpty());
        assertEquals(LineDrawing.LIMIT, shown.drawing().pixels(), "the right line is cut too");
        Texts texts = Texts.of("line", language);
        String note = LineNotes.about(shown, texts).orElseThrow();
        String kept = texts.text("note.tried.first", "bresenham", 4000);
        assertTrue(note.endsWith(kept), note);
        String numbers = new LineReadings(model.state(), texts).other();
        assertEquals(texts.text("tried.wrong", 0, 0, 4000), numbers);
    }

    @ParameterizedTest(name = "a second method is spoken of where it is the program: {0}")
    @EnumSource(Language.class)
    void hintIsOfWhatIsCompared(Language language) throws Exception {
        Texts texts = Texts.of("line", language);
        tried(SHORT, all(0, 0));
        assertEquals(texts.text("apart.hint.tried"), hint(texts));
        model.compareWith("dda");
        settled();
        assertEquals(texts.text("apart.hint"), hint(texts));
    }

    /** The words about the pixels that only one of two lights. */
    private String hint(Texts texts) throws Exception {
        var hint = new AtomicReference<String>();
        EventQueue.invokeAndWait(
                () -> {
                    var inspector = new LineInspector(model, texts);
                    inspector.sections().forEach(Runnable::run);
                    inspector.refresh();
                    Stream.of(inspector.column().getComponents())
                            .filter(each -> "apart.value".equals(each.getName()))
                            .forEach(each -> hint.set(((JComponent) each).getToolTipText()));
                });
        return hint.get();
    }

    @Test
    void programThatPlottedOnIsComparedWithTheWholeLine() {
        LineDrawings shown = tried(SHORT, first(9));
        assertEquals(6, shown.other().orElseThrow().difference().extra().size());
        assertEquals(0, shown.other().orElseThrow().difference().missing().size());
        assertEquals(6, shown.apart().orElseThrow().missing().size());
    }
}
