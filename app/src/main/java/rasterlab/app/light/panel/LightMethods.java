package rasterlab.app.light.panel;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import rasterlab.app.canvas.method.AboutText;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.language.Texts;
import rasterlab.app.light.LightChoice;
import rasterlab.app.light.LightFrame;
import rasterlab.app.light.LitBody;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.pipeline.ShadingMethod;

/** The methods by which a choice is lit, each with its texts. */
final class LightMethods {
    private final Texts texts;

    LightMethods(Texts texts) {
        this.texts = texts;
    }

    /** The three shadings, the specular term, and how normals of corners are mixed, if they are. */
    List<AboutText.Called> of(LightChoice choice) {
        var methods = new ArrayList<AboutText.Called>();
        boolean own = !choice.shaded().isEmpty();
        if (own) methods.add(called("shading.", "shade-face", OwnMethods.NAME));
        for (ShadingMethod shading : LightFrame.SHADINGS)
            if (!own) methods.add(called("shading.", "shade-face", shading.code()));
        String reflection = choice.reflection().name().toLowerCase(Locale.ROOT).replace('_', '-');
        methods.add(called("reflection.", "shade", reflection));
        String normals = choice.body().normals();
        if (!normals.equals(LitBody.OWN))
            methods.add(called("normals.", "vertex-normals", normals));
        return methods;
    }

    private AboutText.Called called(String label, String topic, String name) {
        Texts said = TopicTexts.of(topic, texts.language()).texts();
        return new AboutText.Called(texts.text(label + name), said, name);
    }
}
