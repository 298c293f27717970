package rasterlab.app.exercise.panel;

import java.util.List;
import java.util.Optional;
import javax.swing.JPanel;
import rasterlab.app.canvas.lab.OpenInLab;
import rasterlab.app.course.CourseMapPane;
import rasterlab.app.exercise.ExerciseLabModel;
import rasterlab.app.language.Language;
import rasterlab.engine.Topics;

/** The map of the course in the tab of exercises: made when it is first opened. */
final class CourseMapPlace implements AutoCloseable {
    private final ExerciseLabModel model;
    private final WindowEditor kept;
    private final OpenInLab lab;
    private final Language language;
    private final Runnable turned;
    private Optional<CourseMapPane> made = Optional.empty();

    /**
     * @param kept knows whether the map was shown when the panel before was closed
     * @param turned told that the map comes, or goes
     */
    CourseMapPlace(
            ExerciseLabModel model,
            WindowEditor kept,
            OpenInLab lab,
            Language language,
            Runnable turned) {
        this.model = model;
        this.kept = kept;
        this.lab = lab;
        this.language = language;
        this.turned = turned;
    }

    /** The map; empty while an exercise is shown. */
    Optional<JPanel> shown() {
        if (!kept.isOnMap()) return Optional.empty();
        if (made.isEmpty()) {
            made =
                    Optional.of(
                            new CourseMapPane(
                                    model.standings,
                                    model.exercises(),
                                    language,
                                    this::choose,
                                    this::openLab,
                                    () -> turn(false)));
        }
        return Optional.of(made.get());
    }

    /** Shows the map, and looks how far the student has come. */
    void open() {
        model.standings.look(model.state().account());
        turn(true);
    }

    private void turn(boolean shown) {
        kept.turnToMap(shown);
        turned.run();
    }

    private void choose(String exercise) {
        model.choose(exercise);
        turn(false);
    }

    /** The topic's first hazard is the example that brings its lab to the topic. */
    private void openLab(String topic) {
        List<String> hazards =
                Topics.named(topic).hazards().stream().map(hazard -> hazard.name()).toList();
        lab.showHazard(topic, hazards.get(0), "");
    }

    void focus() {
        made.ifPresent(pane -> pane.focus(model.state().exercise().id()));
    }

    @Override
    public void close() {
        made.ifPresent(CourseMapPane::close);
    }
}
