package rasterlab.app.course;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import javax.swing.AbstractButton;
import javax.swing.JLabel;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.canvas.Parts;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.rooms.LabRooms;
import rasterlab.app.server.CourseServer;
import rasterlab.app.shell.OffscreenPainter;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.engine.Topics;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.course.Chapter;
import rasterlab.exercises.score.ScorePoints;

class CourseMapPaneTest {
    private static final List<Exercise> ALL = Catalogue.builtIn().all();

    private final BlockingQueue<Runnable> events = new LinkedBlockingQueue<>();
    private final List<Throwable> failures = new ArrayList<>();
    private final List<String> asked = new ArrayList<>();

    @TempDir Path drafts;

    @AfterAll
    static void usualLook() throws Exception {
        EventQueue.invokeAndWait(LabTheme.LIGHT::install);
    }

    @Test
    void topicsHaveTheLabThatShowsThemAndItsTabsTitle() {
        for (Language language : List.of(Language.ENGLISH, Language.RUSSIAN)) {
            Texts tabs = Texts.of("shell", language);
            for (String topic : Topics.names()) {
                var chapter = new Chapter(topic, List.of());
                String lab = LabRooms.card(topic).lab().name();
                assertEquals(lab, chapter.lab(), topic);
                assertEquals(
                        tabs.text("tab." + lab),
                        chapter.labTitle(language.locale().getLanguage()),
                        topic);
            }
        }
    }

    @ParameterizedTest(name = "something of the map is cut: {0}, text of {1} % in {2}×{3}")
    @CsvSource({
        "RUSSIAN, 100, 1280, 738",
        "ENGLISH, 100, 1280, 738",
        "RUSSIAN, 100, 900, 538",
        "RUSSIAN, 150, 1280, 738",
        "RUSSIAN, 200, 900, 538"
    })
    void everythingIsReadWhole(Language language, int percent, int width, int height)
            throws Exception {
        var pane = new CourseMapPane[1];
        try (var standings = standings()) {
            LocalTries.note(drafts.resolve("circle.result.json"), new ScorePoints(57, 30, 13, 100));
            show(standings);
            EventQueue.invokeAndWait(
                    () -> {
                        LabTheme.LIGHT.install(percent);
                        pane[0] = pane(standings, language);
                    });
            OffscreenPainter.paint(pane[0], width, height);
            var cut = new ArrayList<String>();
            EventQueue.invokeAndWait(
                    () ->
                            Parts.of(pane[0])
                                    .filter(Component::isVisible)
                                    .filter(each -> each.getWidth() < wanted(each))
                                    .map(CourseMapPaneTest::textOf)
                                    .forEach(cut::add));
            assertEquals(List.of(), cut);
        }
    }

    @ParameterizedTest(name = "of {0} pixels, chapters fill {1} columns or leave the order")
    @CsvSource({"1000, 1", "1580, 2", "2540, 3"})
    void chaptersStandSideBySideInTheCoursesOrder(int width, int abreast) throws Exception {
        var pane = new CourseMapPane[1];
        try (var standings = standings()) {
            EventQueue.invokeAndWait(
                    () -> {
                        LabTheme.LIGHT.install(100);
                        pane[0] = pane(standings, Language.ENGLISH);
                    });
            OffscreenPainter.paint(pane[0], width, 800);
            EventQueue.invokeAndWait(
                    () -> {
                        List<Component> titles =
                                Chapter.of(ALL).stream()
                                        .map(one -> named(pane[0], "map.topic." + one.topic()))
                                        .toList();
                        for (int i = 1; i < titles.size(); i++) {
                            boolean begins = i % abreast == 0;
                            Component before = titles.get(i - (begins ? abreast : 1));
                            Component next = titles.get(i);
                            assertEquals(begins, next.getX() == before.getX(), next.getName());
                            assertEquals(!begins, next.getY() == before.getY(), next.getName());
                        }
                    });
        }
    }

    @Test
    void clickOnAnExerciseOpensItAndOneOnItsLabTheTopic() throws Exception {
        try (var standings = standings()) {
            EventQueue.invokeAndWait(
                    () -> {
                        var pane = pane(standings, Language.ENGLISH);
                        ((AbstractButton) named(pane, "map.exercise.break-ellipse")).doClick();
                        ((AbstractButton) named(pane, "map.lab.color")).doClick();
                        ((AbstractButton) named(pane, "back")).doClick();
                    });
        }
        assertEquals(List.of("exercise break-ellipse", "lab color", "left"), asked);
    }

    @Test
    void tryShowsInTheOpenMapOnceItIsLookedAt() throws Exception {
        try (var standings = standings()) {
            var pane = new CourseMapPane[1];
            EventQueue.invokeAndWait(() -> pane[0] = pane(standings, Language.ENGLISH));
            var state = (JLabel) named(pane[0], "map.state.circle");
            assertEquals("not tried", state.getText());
            LocalTries.note(drafts.resolve("circle.result.json"), new ScorePoints(50, 7, 0, 100));
            show(standings);
            assertEquals("57 of 100", state.getText());
            pane[0].close();
            LocalTries.note(drafts.resolve("circle.result.json"), new ScorePoints(60, 7, 0, 100));
            show(standings);
            assertEquals("57 of 100", state.getText(), "a closed map listens");
        }
    }

    private void show(Standings standings) throws Exception {
        standings.look(Optional.empty());
        Runnable event = events.poll(60, TimeUnit.SECONDS);
        assertTrue(event != null, "nothing is told");
        event.run();
        assertEquals(List.of(), failures);
    }

    private Standings standings() {
        var standings =
                new Standings(CourseServer.ServerTimeouts.USUAL, events::add, failures::add);
        standings.readFrom(drafts);
        return standings;
    }

    private CourseMapPane pane(Standings standings, Language language) {
        return new CourseMapPane(
                standings,
                ALL,
                language,
                exercise -> asked.add("exercise " + exercise),
                topic -> asked.add("lab " + topic),
                () -> asked.add("left"));
    }

    private static int wanted(Component shown) {
        return textOf(shown).isEmpty() ? 0 : shown.getPreferredSize().width;
    }

    private static String textOf(Component shown) {
        if (shown instanceof AbstractButton button) return button.getText();
        return shown instanceof JLabel label && label.getText() != null ? label.getText() : "";
    }

    private static Component named(Container root, String name) {
        Predicate<Component> wanted = each -> name.equals(each.getName());
        return Parts.of(root).filter(wanted).findFirst().orElseThrow();
    }
}
