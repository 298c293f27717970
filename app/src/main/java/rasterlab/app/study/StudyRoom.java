package rasterlab.app.study;

import java.util.List;
import java.util.Map;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.card.LabRoom;
import rasterlab.app.card.LabShot;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.Topics;

/** The tab where speed and accuracy of any topic's methods are measured. */
public final class StudyRoom implements LabRoom<StudyLabModel> {
    @Override
    public String name() {
        return "study";
    }

    @Override
    public StudyLabModel model(Executor events, Consumer<Throwable> onFailure, OwnMethods own) {
        return new StudyLabModel(Topics.all(), own, events, onFailure);
    }

    @Override
    public void keep(StudyLabModel model, Map<String, Kept<?>> kept) {
        kept.put("study", model);
    }

    @Override
    public void close(StudyLabModel model) {
        model.close();
    }

    @Override
    public LabPanel panel(StudyLabModel model, Surroundings around) {
        return new StudyPanel(model, around.opening(), around.language(), around.onFailure());
    }

    @Override
    public boolean playsSteps() {
        return false;
    }

    @Override
    public List<LabShot<StudyLabModel>> shots() {
        return List.of(LabShot.first("study"));
    }
}
