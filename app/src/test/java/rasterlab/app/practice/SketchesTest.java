package rasterlab.app.practice;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.practice.Board.NamedPick;
import rasterlab.app.practice.Board.PixelPick;
import rasterlab.app.practice.Board.RunPick;
import rasterlab.app.practice.Sketch.Walked;
import rasterlab.engine.Topics;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.TaskKind;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.predicting.Question;

/** Each picture of each question of some seeds. */
class SketchesTest {
    private static final long SEEDS = 6;
    private static final Dimension VIEW = new Dimension(800, 560);

    private static final PracticeExercises PRACTISED = new PracticeExercises();

    static Stream<String> drawn() {
        return Catalogue.builtIn().all().stream()
                .filter(one -> one.form() == TaskKind.PREDICT)
                .map(Exercise::topic);
    }

    @Test
    @DisplayName("a sketch draws no topic's questions, or another one draws them in its place")
    void everySketchDrawsItsTopic() {
        assertEquals(
                Set.copyOf(Sketches.ALL),
                drawn().map(topic -> Sketches.drawing(Topics.named(topic)).orElseThrow())
                        .collect(Collectors.toSet()));
    }

    private interface Check {
        void check(Question question, Board board, String place);
    }

    private void each(String topic, Check check) {
        for (long seed = 1; seed <= SEEDS; seed++)
            for (Question question : PRACTISED.sheet(topic, seed).sheet().questions()) {
                Walked walked =
                        new Walked(
                                WalkText.input(question.input()),
                                question.before(),
                                question.givenFields(),
                                Optional.empty());
                String place = topic + ", seed " + seed + ", question " + question.number();
                check.check(question, Sketches.of(topic).orElseThrow().of(walked), place);
            }
    }

    @ParameterizedTest(name = "{0}: the right answer cannot be clicked")
    @MethodSource("drawn")
    void theRightThingAnswersRightly(String topic) {
        each(
                topic,
                (question, board, place) -> {
                    BoardFrame frame = BoardFrame.of(board, VIEW);
                    ObjectNode right = question.right();
                    List<StagePick> picks = clicked(board, frame, right, question.givenFields());
                    assertTrue(
                            picks.isEmpty()
                                    || picks.stream().anyMatch(pick -> isRight(pick, right)),
                            () -> place + ": " + picks + " for " + right);
                });
    }

    /** Whether each field that is picked is right. */
    private static boolean isRight(StagePick pick, ObjectNode right) {
        return pick.answer().properties().stream()
                .allMatch(one -> same(one.getValue(), right.get(one.getKey()), pick.tolerance()));
    }

    private static boolean same(JsonNode one, JsonNode right, double tolerance) {
        return right.isNumber()
                ? Math.abs(one.doubleValue() - right.doubleValue()) <= tolerance
                : one.equals(right);
    }

    /** The answers of clicks at the right places; none where nothing is clicked. */
    private static List<StagePick> clicked(
            Board board, BoardFrame frame, ObjectNode right, ObjectNode told) {
        if (board.picking() instanceof PixelPick pixel)
            return List.of(at(board, frame, number(right, pixel.x()), number(right, pixel.y())));
        if (board.picking() instanceof RunPick run) {
            int y = run.row().isEmpty() ? number(told, "y") : number(right, run.row());
            var from = new Point(number(right, run.from()), y);
            var to = new Point(number(right, run.to()) - 1, y);
            return List.of(StagePick.pixels(run, to, from));
        }
        if (board.picking() instanceof Board.PointPick point)
            return plane(
                    board,
                    frame,
                    new Point2D.Double(
                            right.get(point.x()).doubleValue(),
                            right.get(point.y()).doubleValue()));
        if (!(board.picking() instanceof NamedPick named)) return List.of();
        return named.targets().stream()
                .filter(one -> one.value().asText().equals(right.get(named.field()).asText()))
                .flatMap(one -> one.points().stream())
                .flatMap(one -> plane(board, frame, one).stream())
                .toList();
    }

    private static int number(ObjectNode of, String field) {
        return of.get(field).intValue();
    }

    private static List<StagePick> plane(Board board, BoardFrame frame, Point2D at) {
        Point click = view(frame, at.getX(), at.getY());
        return StagePick.plane(board.picking(), frame.map(), click).stream().toList();
    }

    private static StagePick at(Board board, BoardFrame frame, int x, int y) {
        Point pixel = frame.pixelAt(view(frame, x, y));
        return StagePick.pixels(board.picking(), pixel, pixel);
    }

    private static Point view(BoardFrame frame, double x, double y) {
        return new Point(
                (int) Math.round(frame.map().viewX(x)), (int) Math.round(frame.map().viewY(y)));
    }

    @Test
    @DisplayName("an ear's diagonal is not the one of the method's own step")
    void earsLeaveTheMethodsDiagonals() {
        for (long seed = 1; seed <= SEEDS; seed++)
            for (Question one : PRACTISED.sheet("triangulate", seed).sheet().questions()) {
                JsonNode input = WalkText.input(one.input());
                List<Point2D> corners = QuestionPoints.all(input.path("polygon"));
                Walked walked =
                        new Walked(input, one.before(), one.givenFields(), Optional.empty());
                List<List<Point2D>> drawn =
                        Sketches.of("triangulate").orElseThrow().of(walked).figures().stream()
                                .filter(Board.BoardPath.class::isInstance)
                                .map(Board.BoardPath.class::cast)
                                .filter(path -> !path.closed())
                                .map(Board.BoardPath::points)
                                .toList();
                List<List<Point2D>> right =
                        one.before().stream()
                                .map(step -> step.path("diagonal"))
                                .filter(ends -> ends.size() == 2)
                                .map(
                                        ends ->
                                                List.of(
                                                        corners.get(ends.get(0).intValue()),
                                                        corners.get(ends.get(1).intValue())))
                                .toList();
                assertEquals(right, drawn, one.input());
            }
    }

    @ParameterizedTest(name = "{0}: the answer lies outside the picture")
    @MethodSource("drawn")
    void everythingThatIsAskedForIsInSight(String topic) {
        each(
                topic,
                (question, board, place) -> {
                    if (!(board.picking() instanceof PixelPick pixel)) return;
                    ObjectNode right = question.right();
                    Point at =
                            view(
                                    BoardFrame.of(board, VIEW),
                                    right.get(pixel.x()).intValue(),
                                    right.get(pixel.y()).intValue());
                    assertTrue(new Rectangle(VIEW).contains(at), () -> place + ": " + at);
                });
    }

    @ParameterizedTest(name = "{0}: a wrong answer moves the picture or breaks it")
    @MethodSource("drawn")
    void aWrongAnswerIsDrawnWhereEverythingElseStays(String topic) {
        var image = new BufferedImage(VIEW.width, VIEW.height, BufferedImage.TYPE_INT_RGB);
        Texts texts = Texts.of("practice", Language.ENGLISH);
        each(
                topic,
                (question, board, place) -> {
                    List<JsonNode> steps =
                            Stream.concat(question.before().stream(), Stream.of(question.step()))
                                    .toList();
                    JsonNode input = WalkText.input(question.input());
                    Sketch sketch = Sketches.of(topic).orElseThrow();
                    Board without =
                            sketch.of(
                                    new Walked(
                                            input,
                                            steps,
                                            question.givenFields(),
                                            Optional.empty()));
                    Board with =
                            sketch.of(
                                    new Walked(
                                            input,
                                            steps,
                                            question.givenFields(),
                                            Optional.of(wrong(question.right()))));
                    BoardFrame frame = BoardFrame.of(with, VIEW);
                    assertEquals(BoardFrame.of(without, VIEW), frame, place);
                    var g = image.createGraphics();
                    frame.paintGrid(g, new Font(Font.DIALOG, Font.PLAIN, 13), Locale.ENGLISH);
                    new BoardPainter(g, frame.map(), StageColors.LIGHT, texts).paint(with);
                    frame.paintMargins(g, new Font(Font.DIALOG, Font.PLAIN, 13), Locale.ENGLISH);
                    g.dispose();
                });
    }

    /** The sketch with a wrong number or word in each field. */
    private static ObjectNode wrong(ObjectNode right) {
        ObjectNode wrong = right.deepCopy();
        right.properties()
                .forEach(
                        one -> {
                            if (one.getValue().isNumber())
                                wrong.put(one.getKey(), one.getValue().doubleValue() + 3);
                            else if (one.getValue().isTextual()) wrong.put(one.getKey(), "none");
                        });
        return wrong;
    }
}
