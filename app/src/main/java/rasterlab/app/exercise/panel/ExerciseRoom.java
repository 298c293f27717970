package rasterlab.app.exercise.panel;

import java.util.List;
import java.util.Map;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.card.LabRoom;
import rasterlab.app.card.LabShot;
import rasterlab.app.exercise.ExerciseLabModel;
import rasterlab.app.mine.OwnMethods;
import rasterlab.exercises.catalogue.Catalogue;

/** The tab of exercises. */
public final class ExerciseRoom implements LabRoom<ExerciseRoom.Desk> {
    /**
     * Outlives the panels.
     *
     * @param editor worn by them in turn
     */
    public record Desk(ExerciseLabModel model, WindowEditor editor) {}

    @Override
    public String name() {
        return "exercises";
    }

    @Override
    public String texts() {
        return "exercise";
    }

    @Override
    public Desk model(Executor events, Consumer<Throwable> onFailure, OwnMethods own) {
        var model = new ExerciseLabModel(() -> Catalogue.builtIn().all(), own, events, onFailure);
        model.readAhead();
        return new Desk(model, new WindowEditor());
    }

    @Override
    public void keep(Desk desk, Map<String, Kept<?>> kept) {
        kept.put("exercises", desk.model());
    }

    @Override
    public void close(Desk desk) {
        desk.model().close();
    }

    @Override
    public void prepare(Desk desk) {
        ExercisePanel.prepare(desk.model());
    }

    @Override
    public LabPanel panel(Desk desk, Surroundings around) {
        return new ExercisePanel(
                desk.model(),
                desk.editor(),
                around.opening(),
                around.language(),
                around.onFailure());
    }

    @Override
    public boolean playsSteps() {
        return false;
    }

    @Override
    public List<LabShot<Desk>> shots() {
        return List.of(LabShot.first("exercises"));
    }
}
