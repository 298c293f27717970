package rasterlab.app.study;

import java.util.List;
import java.util.Optional;
import rasterlab.engine.study.HazardTrial.Cell;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Topic;

/**
 * The state that the tab of speed and accuracy shows.
 *
 * @param thorough whether the next measurement takes its time
 * @param view chart or hazards
 * @param study the topic's, once it was measured
 * @param cells the topic's fresh verdicts; fewer than there are pairs while they are being tried
 * @param point the measurement that is chosen on the chart
 * @param hazard name of the chosen cell's hazard; "" where none is chosen
 * @param method name of the method that is explained
 */
public record StudyLabState(
        Topic<?, ?, ?> topic,
        boolean thorough,
        StudyView view,
        Optional<Study> study,
        List<Cell> cells,
        Optional<Measurement> point,
        String hazard,
        String method,
        StudyWork work) {
    public StudyLabState {
        cells = List.copyOf(cells);
    }

    /** The fresh verdict of that pair; empty where it was not tried. */
    Optional<Cell> cell(String ofHazard, String ofMethod) {
        return cells.stream()
                .filter(cell -> cell.hazard().equals(ofHazard) && cell.method().equals(ofMethod))
                .findFirst();
    }

    StudyLabState with(StudyWork next) {
        return new StudyLabState(topic, thorough, view, study, cells, point, hazard, method, next);
    }

    StudyLabState with(StudyView next) {
        return new StudyLabState(topic, thorough, next, study, cells, point, hazard, method, work);
    }

    StudyLabState withThorough(boolean next) {
        return new StudyLabState(topic, next, view, study, cells, point, hazard, method, work);
    }

    StudyLabState with(Study next) {
        return new StudyLabState(
                topic,
                thorough,
                view,
                Optional.of(next),
                cells,
                Optional.empty(),
                hazard,
                method,
                work);
    }

    StudyLabState withCells(List<Cell> next) {
        return new StudyLabState(topic, thorough, view, study, next, point, hazard, method, work);
    }

    StudyLabState with(Measurement next) {
        return new StudyLabState(
                topic,
                thorough,
                view,
                study,
                cells,
                Optional.of(next),
                hazard,
                next.method(),
                work);
    }

    StudyLabState withCell(String nextHazard, String nextMethod) {
        return new StudyLabState(
                topic, thorough, view, study, cells, point, nextHazard, nextMethod, work);
    }
}
