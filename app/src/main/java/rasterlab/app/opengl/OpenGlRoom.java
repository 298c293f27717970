package rasterlab.app.opengl;

import java.util.List;
import java.util.Map;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.card.LabRoom;
import rasterlab.app.card.LabShot;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.opengl.state.Setting;

/** The lab that draws one scene by OpenGL and by the pipeline. */
public final class OpenGlRoom implements LabRoom<OpenGlLabModel> {
    @Override
    public String name() {
        return "opengl";
    }

    @Override
    public OpenGlLabModel model(Executor events, Consumer<Throwable> onFailure, OwnMethods own) {
        return new OpenGlLabModel(events, onFailure);
    }

    @Override
    public void keep(OpenGlLabModel model, Map<String, Kept<?>> kept) {
        kept.put("opengl", model);
        kept.put("opengl.image", model.keptImage());
    }

    @Override
    public void close(OpenGlLabModel model) {
        model.close();
    }

    @Override
    public LabPanel panel(OpenGlLabModel model, Surroundings around) {
        return new OpenGlPanel(model, around.language(), around.onFailure());
    }

    @Override
    public List<LabShot<OpenGlLabModel>> shots() {
        return List.of(LabShot.first("opengl"), new LabShot<>("globe", OpenGlRoom::showGlobe));
    }

    private static void showGlobe(OpenGlLabModel lab) {
        lab.set(Setting.SCENE, "globe");
        lab.set(Setting.MIN_FILTER, "GL_LINEAR_MIPMAP_LINEAR");
    }
}
