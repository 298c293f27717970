package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.canvas.file.ShellPath;
import rasterlab.app.exercise.outcome.CaseResult;
import rasterlab.app.exercise.outcome.Notice;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.app.exercise.outcome.OutcomeFile;
import rasterlab.app.exercise.outcome.Outcomes;
import rasterlab.app.language.Language;
import rasterlab.app.outcome.FileKind;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.score.GradingVerdict;

@Tag("slow")
@Timeout(300)
class ExerciseLabModelTest {
    private static final String HEAD =
            "public class A implements rasterlab.contract.LineRasterizer {\n"
                    + "  public void draw(int x0, int y0, int x1, int y1,"
                    + " rasterlab.contract.Pixels out) {\n";
    private static final String FIRST_PIXEL = HEAD + "    out.plot(x0, y0);\n  }\n}\n";
    private static final String ENDLESS = HEAD + "    while (true) x0++;\n  }\n}\n";

    @TempDir Path folder;

    @Test
    void beginsWithTheStarter() {
        try (var trial = new Trial(folder)) {
            assertEquals(trial.state().exercise().starter(), trial.state().source());
            assertEquals(Notice.NONE, trial.state().notice());
        }
    }

    @Test
    void catalogueIsReadOnceBeforeTheTabIsThere() throws InterruptedException {
        var readers = new ArrayList<Thread>();
        var model =
                new ExerciseLabModel(
                        () -> {
                            readers.add(Thread.currentThread());
                            return Catalogue.builtIn().all();
                        },
                        Runnable::run,
                        failure -> {});
        try (model) {
            var ahead = new Thread(model::exercises);
            ahead.start();
            ahead.join();
            model.exercises();
            model.state();
            assertEquals(List.of(ahead), readers);
        }
    }

    @Test
    void typedTextOutlivesTheWindow() {
        try (var trial = new Trial(folder)) {
            trial.model.type(FIRST_PIXEL);
        }
        try (var trial = new Trial(folder)) {
            assertEquals(FIRST_PIXEL, trial.state().source());
        }
    }

    @Test
    void resultOutlivesTheWindowAndIsToldAsOfAnOlderText() throws Exception {
        Outcome told;
        try (var trial = new Trial(folder)) {
            trial.model.type(FIRST_PIXEL);
            trial.model.check();
            told = trial.awaitEnd().outcome().orElseThrow();
        }
        try (var trial = new Trial(folder)) {
            ExerciseState state = trial.await("the result", each -> each.outcome().isPresent());
            assertTrue(state.upToDate());
            assertEquals(json(told), json(state.outcome().orElseThrow()));
            trial.model.type(ENDLESS);
            assertFalse(trial.state().upToDate());
        }
        try (var trial = new Trial(folder)) {
            ExerciseState state = trial.await("the result", each -> each.outcome().isPresent());
            assertFalse(state.upToDate());
            assertEquals(FIRST_PIXEL, state.outcome().orElseThrow().source());
        }
    }

    /** Pictures too, byte for byte. */
    private String json(Outcome outcome) throws Exception {
        Path file = folder.resolve("compared.json");
        OutcomeFile.write(file, Catalogue.builtIn().all().get(0), outcome);
        return Files.readString(file);
    }

    @Test
    void resultThatIsBrokenOrOfAnotherRevisionIsNotShown() throws Exception {
        Exercise exercise = Catalogue.builtIn().all().get(0);
        Path file = folder.resolve(exercise.id() + ".result.json");
        OutcomeFile.write(file, exercise, ShownResult.outcome(GradingVerdict.WRONG));
        assertTrue(OutcomeFile.read(file, exercise).isPresent());
        String whole = Files.readString(file);
        String ofAnotherRevision = whole.replace(exercise.revision(), "older");
        String ofABrokenScene = whole.replaceFirst("\"scene\":\"", "$0{");
        assertNotEquals(whole, ofAnotherRevision);
        assertNotEquals(whole, ofABrokenScene);
        for (String broken :
                List.of(
                        ofAnotherRevision,
                        ofABrokenScene,
                        "",
                        "{",
                        "null",
                        whole.substring(9),
                        whole.replace("\"of\":100", "\"of\":-1"))) {
            Files.writeString(file, broken);
            assertEquals(Optional.empty(), OutcomeFile.read(file, exercise), broken);
        }
    }

    @Test
    void resultThatIsTooLongToBeReadAgainIsLeftOutWithTheOlderOne() throws Exception {
        Exercise exercise = Catalogue.builtIn().all().get(0);
        Path file = folder.resolve(exercise.id() + ".result.json");
        Outcome usual = ShownResult.outcome(GradingVerdict.WRONG);
        var tooLong =
                new Outcome(
                        "x".repeat(FileKind.RESULT.most()),
                        usual.attempt(),
                        usual.verdict(),
                        usual.points(),
                        usual.cases(),
                        usual.remarks(),
                        usual.isolation(),
                        usual.nanosPerItem(),
                        false);
        try (var outcomes = new Outcomes(id -> Optional.of(file), Runnable::run)) {
            outcomes.keep(exercise, usual);
        }
        assertTrue(Files.exists(file));
        try (var outcomes = new Outcomes(id -> Optional.of(file), Runnable::run)) {
            outcomes.keep(exercise, tooLong);
        }
        assertFalse(Files.exists(file));
    }

    @Test
    void secondWindowOffersTheFirstOnesTextAndKeepsIt() throws Exception {
        try (var first = new Trial(folder);
                var second = new Trial(folder)) {
            first.model.type("first");
            first.model.unsavedDrafts();
            assertEquals("first", second.state().source());
            second.model.type("second");
            second.model.unsavedDrafts();
            first.model.unsavedDrafts();
        }
        try (var again = new Trial(folder)) {
            assertEquals("first", again.state().source());
            assertEquals("second", again.state().otherDrafts().get(0).text());
            new OtherTexts(again.model).take(again.state().otherDrafts().get(0));
            assertEquals("second", again.state().source());
            assertEquals(List.of(), again.state().otherDrafts());
        }
    }

    @Test
    void exerciseAndSizeOfTypeAreKept() {
        ExerciseChoice left;
        try (var trial = new Trial(folder)) {
            trial.state();
            trial.model.growType(3);
            left = trial.model.kept();
        }
        assertEquals(new ExerciseChoice("line-bresenham", 3), left);
        try (var trial = new Trial(folder)) {
            trial.model.restore(left);
            assertEquals(left, trial.model.kept());
            assertEquals("line-bresenham", trial.state().exercise().id());
        }
    }

    @Test
    void secondExerciseIsShownAgainAndOneThatIsGoneGivesWayToTheFirst() {
        try (var model = twoExercises()) {
            model.choose("second");
            assertEquals("second", model.kept().exercise());
        }
        try (var model = twoExercises()) {
            model.restore(new ExerciseChoice("second", 0));
            assertEquals("second", model.state().exercise().id());
        }
        try (var model = twoExercises()) {
            model.restore(new ExerciseChoice("gone", 0));
            assertEquals("line-bresenham", model.state().exercise().id());
        }
    }

    private static ExerciseLabModel twoExercises() {
        Exercise first = Catalogue.builtIn().named("line-bresenham");
        var second =
                new Exercise(
                        "second",
                        first.topic(),
                        first.title(),
                        first.statement(),
                        first.pictures(),
                        first.starter(),
                        first.revision(),
                        first.tolerance(),
                        first.points(),
                        first.cases());
        return new ExerciseLabModel(
                () -> List.of(first, second),
                Runnable::run,
                failure -> {
                    throw new AssertionError(failure);
                });
    }

    @Test
    void unwrittenTextsAreListedUntilTheyCanBeWritten() throws Exception {
        Files.writeString(folder.resolve("drafts"), "in the way");
        try (var trial = new Trial(folder)) {
            trial.state();
            assertEquals(List.of(), trial.model.unsavedDrafts());
            trial.model.type("typed");
            UnsavedDraft lost = trial.model.unsavedDrafts().get(0);
            assertEquals("line-bresenham", lost.exercise());
            assertEquals("typed", lost.text());
            assertTrue(lost.problem().contains(folder.resolve("drafts").toString()));
            Files.delete(folder.resolve("drafts"));
            assertEquals(List.of(), trial.model.unsavedDrafts());
        }
        try (var trial = new Trial(folder)) {
            assertEquals("typed", trial.state().source());
        }
    }

    @Test
    void unwritableFolderIsToldAndTheTextStays() throws Exception {
        Files.writeString(folder.resolve("drafts"), "in the way");
        try (var trial = new Trial(folder)) {
            trial.model.type("typed");
            var state = trial.await("it is told", now -> !now.unsaved().isEmpty());
            assertEquals("typed", state.source());
            assertEquals("draft.unsaved", state.unsaved().key());
            Files.delete(folder.resolve("drafts"));
            trial.model.type("typed on");
            trial.await("it is saved", now -> now.unsaved().isEmpty());
        }
    }

    @Test
    void checkTellsEachCaseAndShowsTheSmallestCounterexample() throws Exception {
        try (var trial = new Trial(folder)) {
            List<Integer> done = new ArrayList<>();
            trial.model.type(FIRST_PIXEL);
            trial.model.listen(state -> done.add(state.work().done()));
            trial.model.check();
            Outcome outcome = trial.awaitEnd().outcome().orElseThrow();
            assertEquals("wrong", outcome.verdict());
            assertTrue(done.contains(5), done.toString());
            CaseResult smallest = outcome.smallestCounterexample().orElseThrow();
            assertTrue(smallest.scene().contains("\"topic\":\"line\""), smallest.scene());
            assertTrue(smallest.scene().contains("\"drawn\":[["), smallest.scene());
            assertTrue(
                    smallest.message().english().contains("by the property it is"),
                    smallest.message().english());
            assertNotEquals(smallest.message().in(Language.RUSSIAN), smallest.message().english());
            for (CaseResult other : outcome.cases())
                if (!other.pictures().isEmpty())
                    assertTrue(smallest.pixels() <= other.pixels(), other.name());
            assertTrue(trial.state().upToDate());
            trial.model.type(FIRST_PIXEL + " ");
            assertFalse(trial.state().upToDate());
        }
    }

    @Test
    void remarksOfTheCompilerAndOfTheByteCodeCheckHaveTheirLines() throws Exception {
        try (var trial = new Trial(folder)) {
            trial.model.type("public class A {\n  int x = ;\n}\n");
            trial.model.check();
            Outcome compiled = trial.awaitEnd().outcome().orElseThrow();
            assertEquals("compile_error", compiled.verdict());
            assertEquals(2, compiled.remarks().get(0).line());
            trial.model.type(HEAD + "    System.exit(0);\n  }\n}\n");
            trial.model.check();
            Outcome refused = trial.awaitEnd().outcome().orElseThrow();
            assertEquals("refused", refused.verdict());
            assertEquals(3, refused.remarks().get(0).line());
        }
    }

    @Test
    void cancelledCheckIsNotHeardOfAndTheNextOneIs() throws Exception {
        try (var trial = new Trial(folder)) {
            trial.model.type(ENDLESS);
            trial.model.check();
            trial.model.cancel();
            assertFalse(trial.state().work().running());
            assertEquals("cancelled", trial.state().notice().key());
            trial.model.type(FIRST_PIXEL);
            trial.model.check();
            Outcome outcome = trial.awaitEnd().outcome().orElseThrow();
            assertEquals(FIRST_PIXEL, outcome.source());
            assertEquals("wrong", outcome.verdict());
        }
    }

    @Test
    void endlessMethodIsToldByTheCaseThatItHungIn() throws Exception {
        try (var trial = new Trial(folder)) {
            trial.model.type(ENDLESS);
            trial.model.check();
            Outcome outcome = trial.awaitEnd().outcome().orElseThrow();
            assertEquals(
                    "not run: your method was stopped in 5 cases before",
                    outcome.cases().get(5).message().english());
            String told = outcome.mostTelling().orElseThrow().message().english();
            assertTrue(told.startsWith("no answer within"), told);
        }
    }

    @Test
    void commandChecksTheTextThatIsKept() throws Exception {
        try (var trial = new Trial(folder)) {
            assertEquals(Optional.empty(), trial.model.command());
            trial.model.type(FIRST_PIXEL);
            trial.model.unsavedDrafts();
            Path draft = folder.resolve("drafts").resolve("line-bresenham.java");
            assertEquals(
                    Optional.of("./lab check line-bresenham " + ShellPath.quoted(draft)),
                    trial.model.command());
            assertEquals(FIRST_PIXEL, Files.readString(draft));
        }
    }

    @Test
    void starterComesBackAndIsKept() throws Exception {
        try (var trial = new Trial(folder)) {
            trial.model.type("mine");
            trial.model.restoreStarter();
            trial.model.unsavedDrafts();
            assertEquals(trial.state().exercise().starter(), trial.state().source());
        }
        try (var trial = new Trial(folder)) {
            assertEquals(trial.state().exercise().starter(), trial.state().source());
        }
    }

    @Test
    void theStarterOfPredictionsIsANewSheetEachTime() throws Exception {
        try (var trial = new Trial(folder)) {
            trial.model.choose("predict-line");
            String first = trial.state().source();
            trial.model.restoreStarter();
            assertTrue(first.contains("\"questions\""), first);
            assertNotEquals(first, trial.state().source());
        }
    }
}
