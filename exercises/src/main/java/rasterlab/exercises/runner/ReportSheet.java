package rasterlab.exercises.runner;

import static java.util.stream.Collectors.joining;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Criterion;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Report;
import rasterlab.exercises.score.ScorePoints;

/** Adds up points and puts the report together. */
final class ReportSheet {
    private final Exercise exercise;
    private final int possible;
    private final String isolation;

    /**
     * @param isolation name of what shut the method in
     */
    ReportSheet(Exercise exercise, CaseSelection selection, String isolation) {
        this.exercise = exercise;
        this.possible =
                exercise.points().speed()
                        + GradingRun.selected(exercise, selection).stream()
                                .mapToInt(Case::points)
                                .sum();
        this.isolation = isolation;
    }

    /** Nothing was run. */
    Report rejected(GradingVerdict verdict, List<Diagnostic> reasons) {
        return new Report(
                verdict, new ScorePoints(0, 0, 0, possible), List.of(), reasons, isolation, 0);
    }

    /**
     * The report of what was tried.
     *
     * @param withheld cases whose points do not count
     */
    Report graded(
            List<CaseReport> cases,
            List<Case> withheld,
            CaseReport speed,
            List<Diagnostic> printed,
            double nanos) {
        List<CaseReport> all = new ArrayList<>(cases);
        all.add(speed);
        lineOn(withheld).ifPresent(all::add);
        GradingVerdict verdict =
                cases.stream()
                        .map(CaseReport::verdict)
                        .filter(one -> one != GradingVerdict.OK)
                        .map(GradingVerdict::published)
                        .findFirst()
                        .orElse(GradingVerdict.OK);
        ScorePoints points =
                new ScorePoints(
                        earned(cases, Criterion.ACCURACY) - sum(withheld, Criterion.ACCURACY),
                        earned(cases, Criterion.STABILITY) - sum(withheld, Criterion.STABILITY),
                        speed.points(),
                        possible);
        return new Report(verdict, points, all, printed, isolation, nanos);
    }

    private int earned(List<CaseReport> cases, Criterion kind) {
        List<String> names =
                exercise.cases().stream()
                        .filter(one -> one.kind() == kind)
                        .map(Case::name)
                        .toList();
        return cases.stream()
                .filter(one -> names.contains(one.name()))
                .mapToInt(CaseReport::points)
                .sum();
    }

    static int sum(List<Case> cases, Criterion kind) {
        return cases.stream().filter(one -> one.kind() == kind).mapToInt(Case::points).sum();
    }

    private Optional<CaseReport> lineOn(List<Case> withheld) {
        int points = withheld.stream().mapToInt(Case::points).sum();
        return points == 0
                ? Optional.empty()
                : Optional.of(
                        CaseReport.withheld(points, kinds(withheld, "en"), kinds(withheld, "ru")));
    }

    private String kinds(List<Case> cases, String language) {
        return cases.stream()
                .map(
                        one ->
                                exercise.group(one)
                                        .map(group -> group.title(language))
                                        .orElse(one.title(language)))
                .distinct()
                .collect(joining("; "));
    }
}
