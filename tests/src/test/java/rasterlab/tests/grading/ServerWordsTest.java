package rasterlab.tests.grading;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.HashSet;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.SourceEncoding;
import rasterlab.exercises.score.Phrase;
import rasterlab.grader.limits.Allowance;
import rasterlab.grader.problem.HiddenByExam;
import rasterlab.grader.problem.Rejection;

/** The server says no in English; the window says it in its own language. */
class ServerWordsTest {
    private static final Allowance ALLOWANCE =
            new Allowance(20, 0, Duration.ofMinutes(1), Duration.ofSeconds(30));

    private static final Pattern ENGLISH =
            Pattern.compile("\\b(the|no|of|at|you|only|must|this|send)\\b");

    /**
     * The refusals that the window never causes, since it makes requests as they should be, or
     * tells by its own words, as that there are no more hints.
     */
    private static final Set<Class<?>> OF_OTHER_CLIENTS =
            Set.of(
                    Rejection.NotSignedIn.class,
                    Rejection.ForeignOrigin.class,
                    Rejection.Malformed.class,
                    Rejection.BadKey.class,
                    Rejection.BadAnswers.class,
                    Rejection.Explained.class,
                    Rejection.HintOrder.class,
                    Rejection.NoMoreHints.class,
                    Rejection.NothingToChoose.class,
                    Rejection.UnknownLanguage.class,
                    Rejection.UnknownScene.class,
                    Rejection.UnknownStudent.class,
                    Rejection.UnknownStaff.class,
                    Rejection.UnknownWorker.class,
                    Rejection.UnknownPlatform.class,
                    Rejection.LastInstructor.class,
                    Rejection.UnknownExam.class,
                    Rejection.ExamNotOpen.class,
                    Rejection.ExamOver.class,
                    Rejection.WrongMethod.class,
                    Rejection.WrongMediaType.class);

    /** The refusals that a student can cause by what the window sends. */
    static Stream<Rejection> rejections() {
        return Stream.of(
                new Rejection.UnknownExercise("circle"),
                new Rejection.UnknownSubmission("7"),
                new HiddenByExam("7"),
                new Rejection.UnknownPicture("steep", "actual"),
                new Rejection.UnknownCourse("XWS74GKU"),
                new Rejection.WrongRole("student"),
                new Rejection.BadName("name", 80),
                new Rejection.KeyReused(),
                new Rejection.EmptySource(),
                new Rejection.NotUtf8("byte 3", SourceEncoding.OTHER),
                new Rejection.NotUtf8("byte 3", SourceEncoding.WINDOWS_1251),
                new Rejection.NotUtf8("byte 3", SourceEncoding.UTF_16),
                new Rejection.Kotlin(),
                new Rejection.TooLarge(65536),
                new Rejection.TooSlow(30),
                new Rejection.TooManyQueued(5, 10, ALLOWANCE),
                new Rejection.TooFast(ALLOWANCE),
                new Rejection.BadSheet(
                        new CatalogueException(Phrase.of("predict.other-seed", "5", "6"))),
                new Rejection.BadSheet(new CatalogueException(Phrase.of("predict.unanswered", 16))),
                new Rejection.NotOpen("circle", Instant.EPOCH, Instant.EPOCH),
                new Rejection.NoAttemptsLeft("circle", 3),
                new Rejection.Late(Instant.EPOCH, new Rejection.Lateness.Marked()),
                new Rejection.Late(
                        Instant.EPOCH, new Rejection.Lateness.TakesPoints(40, Instant.EPOCH)),
                new Rejection.Late(
                        Instant.EPOCH, new Rejection.Lateness.TakesDay(1, 2, Instant.EPOCH)),
                new Rejection.Late(Instant.EPOCH, new Rejection.Lateness.Practice(Instant.EPOCH)),
                new Rejection.InExam("Spring"),
                new Rejection.ExamAddress("192.0.2.1"),
                new Rejection.OtherSession(),
                new Rejection.OnlyLooks(),
                new Rejection.NoRoom());
    }

    @Test
    @DisplayName("a refusal is neither tried nor known to come from other clients only")
    void everyRefusalIsTried() {
        var known = new HashSet<Class<?>>(OF_OTHER_CLIENTS);
        rejections().map(Rejection::getClass).forEach(known::add);
        assertEquals(Set.of(Rejection.class.getPermittedSubclasses()), known);
    }

    @ParameterizedTest
    @MethodSource("rejections")
    void refusalIsSaidInRussian(Rejection rejection) {
        assertTrue(ENGLISH.matcher(rejection.getMessage()).find(), "looks for what is not said");
        String said = Complaints.translated(Language.RUSSIAN, rejection.getMessage());
        assertFalse(ENGLISH.matcher(said).find(), said);
        assertFalse(Pattern.compile("\\d s\\b").matcher(said).find(), said);
    }
}
