package rasterlab.app.light;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import rasterlab.app.canvas.file.KeptFile;
import rasterlab.app.outcome.Complaint;
import rasterlab.engine.scene.obj.UpAxis;

/** Shows the user's scenes in the lab; of an earlier run's only the body. */
final class LitSceneOpening
        implements KeptFile.FileLab<LitFile, LitBody, LitSceneOpening.LitSceneAnswer> {
    /**
     * @param opened empty where there is a problem
     */
    record LitSceneAnswer(Path file, Optional<OpenedLitScene> opened, String problem) {}

    private final LightLabModel model;

    LitSceneOpening(LightLabModel model) {
        this.model = model;
    }

    @Override
    public Class<LitFile> keptType() {
        return LitFile.class;
    }

    @Override
    public LitBody shown() {
        return model.state().choice().body();
    }

    @Override
    public LitFile files(LitBody shown) {
        return LitFile.of(shown);
    }

    @Override
    public LitBody place(LitBody shown) {
        return shown;
    }

    /**
     * @param before what is shown, of which stays what the file does not say
     */
    static Supplier<LitSceneAnswer> reading(Path file, LightChoice before) {
        return () -> read(file, scene -> OpenedLitScene.read(scene, before));
    }

    /** Reads the body that is lit again, with another axis up; its normals stay. */
    static Supplier<LitSceneAnswer> standing(LightChoice before, UpAxis up) {
        Path file = before.body().opened().orElseThrow().file();
        return () -> read(file, model -> OpenedLitScene.standing(model, up, before));
    }

    @Override
    public Optional<Supplier<LitSceneAnswer>> reading(LitFile kept, LitBody before) {
        LightChoice now = model.state().choice();
        return kept.file()
                .map(
                        file ->
                                () ->
                                        read(
                                                file,
                                                scene ->
                                                        OpenedLitScene.again(
                                                                scene, kept.up(), now)));
    }

    private static LitSceneAnswer read(Path file, Function<Path, OpenedLitScene> reader) {
        try {
            return new LitSceneAnswer(file, Optional.of(reader.apply(file)), "");
        } catch (Complaint complaint) {
            return new LitSceneAnswer(file, Optional.empty(), complaint.getMessage());
        }
    }

    @Override
    public boolean open(LitSceneAnswer read) {
        if (read.opened().isEmpty()) {
            tell(read.problem());
            return false;
        }
        OpenedLitScene scene = read.opened().get();
        model.open(scene.choice());
        if (scene.whole()) model.keep(new LitSceneFile(read.file(), scene.choice()));
        String told = scene.notes(read.file());
        if (!told.isEmpty()) tell(told);
        return true;
    }

    @Override
    public String restore(LitFile kept, LitSceneAnswer read) {
        if (read.opened().isEmpty())
            return read.problem() + "; the scene " + shown().name() + " is shown instead";
        model.restore(read.opened().get().choice().body().withNormals(kept.normals()));
        return "";
    }

    @Override
    public String remark() {
        return model.state().problem();
    }

    @Override
    public void tell(String problem) {
        model.tellProblem(problem);
    }
}
