package rasterlab.exercises.proving;

import static java.util.stream.Collectors.joining;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Criterion;
import rasterlab.exercises.Grading;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.predicting.SheetText;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Report;
import rasterlab.exercises.topic.TopicGradings;

/** Tries on an exercise what its topic knows to be right and wrong, and the exercise's sources. */
public final class Proving {
    private final Exercise exercise;
    private final TopicGrading grading;
    private final Topic<?, ?, ?> topic;
    private final Map<Case, List<TopicGrading.GradedCall>> calls;

    private Proving(Exercise exercise, long seed) {
        this.exercise = exercise;
        this.grading = TopicGradings.of(exercise);
        this.topic = Topics.named(exercise.topic());
        this.calls = GradedMethod.calls(exercise, grading, seed);
    }

    /** The proof without the exercise's sources. */
    public static Proof of(Exercise exercise, long seed) {
        if (exercise.form() == Exercise.TaskKind.BREAK) return BreakProving.of(exercise, seed);
        if (exercise.form() == Exercise.TaskKind.PREDICT) return PredictProving.of(exercise, seed);
        Proving proving = new Proving(exercise, seed);
        return new Proof(
                exercise,
                seed,
                proving.right(),
                proving.kills(),
                Optional.empty(),
                Optional.empty());
    }

    /** The whole proof: the judge tries starter and model solution as a student's. */
    public static Proof of(Exercise exercise, long seed, Grading judge)
            throws InterruptedException {
        Proof known = of(exercise, seed);
        Optional<SourcePoints> model = Optional.empty();
        if (exercise.evidence().model().isPresent())
            model = Optional.of(points(exercise, exercise.evidence().model().get(), seed, judge));
        return new Proof(
                exercise,
                seed,
                known.right(),
                known.kills(),
                Optional.of(points(exercise, starter(exercise, seed), seed, judge)),
                model);
    }

    /** The sheet that students begin with whose cases the seed draws. */
    private static String starter(Exercise exercise, long seed) {
        return exercise.form() == Exercise.TaskKind.PREDICT
                ? SheetText.open(exercise, seed)
                : exercise.starter();
    }

    private static SourcePoints points(Exercise exercise, String source, long seed, Grading judge)
            throws InterruptedException {
        Report report = judge.grade(exercise, source, CaseSelection.all(seed), done -> {});
        boolean accepted = !report.cases().isEmpty();
        String why =
                accepted
                        ? ""
                        : report.diagnostics().stream()
                                .map(one -> one.line() + ": " + one.message("en"))
                                .collect(joining("; "));
        GradingVerdict verdict = report.verdict();
        return new SourcePoints(
                verdict, report.points(), why, report.speedObstacle(), !report.speedIsUnsettled());
    }

    private List<RightMethod> right() {
        List<RightMethod> right = new ArrayList<>();
        for (Method<?> one : topic.methods())
            if (!one.faulty()) {
                GradedMethod tried = tried(one.implementation());
                right.add(
                        new RightMethod(
                                one.name(),
                                promises(one),
                                tried.points(Criterion.ACCURACY),
                                tried.points(Criterion.STABILITY),
                                tried.failed(),
                                tried.refused(),
                                tried.breaking()));
            }
        return right;
    }

    /** Where the exercise's right answers are those of one method, no other promises them. */
    private boolean promises(Method<?> one) {
        return exercise.tolerance()
                .truth()
                .map(one.name()::equals)
                .orElseGet(one::promisesToBeRight);
    }

    private List<Kill> kills() {
        List<Kill> kills = new ArrayList<>();
        for (Method<?> one : topic.methods())
            if (one.faulty()) kills.add(kill(one.name(), false, true, one.implementation()));
        for (Mutant<?> one : topic.mutants(exercise.tolerance().truth()))
            kills.add(kill(one.name(), true, isAnswered(one.hazard()), one.implementation()));
        return kills;
    }

    private Kill kill(String name, boolean mutant, boolean answered, Object method) {
        GradedMethod tried = tried(method);
        Set<String> codes = codes(name);
        // what a topic sees in an answer by itself may be nothing, as where nothing was drawn
        boolean byName = codes.size() == 1;
        boolean asked = answered && !exercise.evidence().notAsked().contains(name);
        return new Kill(
                name,
                mutant,
                asked,
                tried.failed(),
                tried.naming(codes),
                tried.breaking(),
                byName && tried.answeredWrong());
    }

    /**
     * The codes that a mistake has: its name, and those of a topic that tells mistakes by what it
     * sees in the answer.
     */
    private Set<String> codes(String name) {
        Set<String> codes = new HashSet<>(grading.mistakes());
        topic.methods().forEach(one -> codes.remove(one.name()));
        topic.allMutants().forEach(one -> codes.remove(one.name()));
        codes.add(name);
        return codes;
    }

    /** A mistake that shows only where an input has to be refused is asked for by no case. */
    private boolean isAnswered(String hazard) {
        return topic.hazards().stream()
                .filter(one -> one.name().equals(hazard))
                .map(Hazard::recorded)
                .anyMatch(recorded -> recorded.containsValue(Verdict.Kind.EXACT));
    }

    private GradedMethod tried(Object method) {
        return GradedMethod.on(exercise, calls, method);
    }
}
