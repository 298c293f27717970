package rasterlab.app.study;

import java.util.List;
import java.util.Optional;
import rasterlab.app.study.chart.StudyWork;
import rasterlab.engine.study.HazardTrial.VerdictCell;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.ParetoFront;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Topic;

/**
 * The state that the tab of speed and accuracy shows.
 *
 * @param thorough whether the next measurement takes its time
 * @param view chart or hazards
 * @param study the topic's, once it was measured
 * @param cells the topic's fresh verdicts; fewer than there are pairs while they are being tried
 * @param level name of the workload that was chosen for the chart; "" for the one that tells most
 * @param marked name of the method whose point is chosen on the chart; "" where none is
 * @param hazard name of the chosen cell's hazard; "" where none is chosen
 * @param method name of the method that is explained
 */
public record StudyLabState(
        Topic<?, ?, ?> topic,
        boolean thorough,
        StudyView view,
        Optional<Study> study,
        List<VerdictCell> cells,
        String level,
        String marked,
        String hazard,
        String method,
        StudyWork work) {
    public StudyLabState {
        cells = List.copyOf(cells);
    }

    /** The study with the cost that is charted; as it was measured where none is. */
    Optional<Study> shownStudy() {
        return study.map(view.cost().orElse(StudyCost.TIME)::of);
    }

    /** Name of the workload that the chart shows; empty where there is no chart. */
    Optional<String> shownLevel() {
        return shownStudy()
                .filter(one -> !one.measurements().isEmpty())
                .map(one -> has(one, level) ? level : ParetoFront.telling(one));
    }

    private static boolean has(Study study, String level) {
        return study.measurements().stream()
                .filter(one -> one.workload().equals(level))
                .anyMatch(one -> one.cost().timed());
    }

    /** The point that is chosen: what is known by now of that method at the level shown. */
    public Optional<Measurement> point() {
        return shownLevel()
                .flatMap(
                        shown ->
                                shownStudy().orElseThrow().measurements().stream()
                                        .filter(one -> one.workload().equals(shown))
                                        .filter(one -> one.method().equals(marked))
                                        .filter(one -> one.cost().timed())
                                        .findFirst());
    }

    /** The fresh verdict of that pair; empty where it was not tried. */
    Optional<VerdictCell> cell(String ofHazard, String ofMethod) {
        return cells.stream()
                .filter(cell -> cell.hazard().equals(ofHazard) && cell.method().equals(ofMethod))
                .findFirst();
    }

    StudyLabState with(StudyWork next) {
        return new StudyLabState(
                topic, thorough, view, study, cells, level, marked, hazard, method, next);
    }

    StudyLabState with(StudyView next) {
        return new StudyLabState(
                topic, thorough, next, study, cells, level, marked, hazard, method, work);
    }

    StudyLabState withThorough(boolean next) {
        return new StudyLabState(
                topic, next, view, study, cells, level, marked, hazard, method, work);
    }

    /** This state with other measurements; the chosen point stays that of its method and level. */
    StudyLabState with(Study next) {
        return new StudyLabState(
                topic,
                thorough,
                view,
                Optional.of(next),
                cells,
                level,
                marked,
                hazard,
                method,
                work);
    }

    StudyLabState withCells(List<VerdictCell> next) {
        return new StudyLabState(
                topic, thorough, view, study, next, level, marked, hazard, method, work);
    }

    StudyLabState withLevel(String next) {
        return new StudyLabState(
                topic, thorough, view, study, cells, next, marked, hazard, method, work);
    }

    StudyLabState with(Measurement next) {
        return new StudyLabState(
                topic,
                thorough,
                view,
                study,
                cells,
                next.workload(),
                next.method(),
                hazard,
                next.method(),
                work);
    }

    StudyLabState withCell(String nextHazard, String nextMethod) {
        return new StudyLabState(
                topic, thorough, view, study, cells, level, marked, nextHazard, nextMethod, work);
    }
}
