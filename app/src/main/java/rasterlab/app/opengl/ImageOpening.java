package rasterlab.app.opengl;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import rasterlab.app.canvas.file.KeptFile;
import rasterlab.app.opengl.state.GlChoice;
import rasterlab.app.opengl.state.Setting;

/** Makes the user's images the lab's texture. */
final class ImageOpening implements KeptFile.FileLab<KeptImage, GlChoice, ImageLoading> {
    private final OpenGlLabModel model;

    ImageOpening(OpenGlLabModel model) {
        this.model = model;
    }

    @Override
    public Class<KeptImage> keptType() {
        return KeptImage.class;
    }

    @Override
    public GlChoice shown() {
        return model.state().choice();
    }

    @Override
    public KeptImage files(GlChoice shown) {
        return KeptImage.of(shown);
    }

    @Override
    public Object place(GlChoice shown) {
        return List.of(shown.get(Setting.IMAGE), shown.file());
    }

    @Override
    public Optional<Supplier<ImageLoading>> reading(KeptImage kept, GlChoice before) {
        return kept.file().map(model::reading);
    }

    @Override
    public boolean open(ImageLoading read) {
        read.image().ifPresent(model::open);
        read.problem().ifPresent(this::tellOfImage);
        return read.image().isPresent();
    }

    private void tellOfImage(String problem) {
        model.touch(Setting.IMAGE);
        tell(problem);
    }

    @Override
    public String restore(KeptImage kept, ImageLoading read) {
        read.image().ifPresent(image -> model.restore(image, kept.shown()));
        if (read.problem().isEmpty()) return "";
        model.touch(Setting.IMAGE);
        return read.problem().get() + "; an image of the lab is shown instead";
    }

    @Override
    public String remark() {
        return model.state().problem().orElse("");
    }

    @Override
    public void tell(String problem) {
        model.tellProblem(Optional.of(problem).filter(said -> !said.isEmpty()));
    }
}
