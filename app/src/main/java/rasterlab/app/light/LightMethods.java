package rasterlab.app.light;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import rasterlab.app.canvas.AboutText;
import rasterlab.app.language.Texts;
import rasterlab.engine.pipeline.ShadingMethod;

/** The methods by which a choice is lit, each with its texts. */
final class LightMethods {
    private final Texts texts;
    private final Texts explanations;

    LightMethods(Texts texts) {
        this.texts = texts;
        explanations = Texts.of("light", "topic", texts.language());
    }

    /** The three shadings, the specular term, and how normals of corners are mixed, if they are. */
    List<AboutText.Called> of(LightChoice choice) {
        var methods = new ArrayList<AboutText.Called>();
        for (ShadingMethod shading : LightFrame.SHADINGS)
            methods.add(called("shading.", "face.", shading.code()));
        String reflection = choice.reflection().name().toLowerCase(Locale.ROOT).replace('_', '-');
        methods.add(called("reflection.", "shade.", reflection));
        String normals = choice.body().normals();
        if (!normals.equals(Body.OWN)) methods.add(called("normals.", "normals.", normals));
        return methods;
    }

    private AboutText.Called called(String label, String key, String name) {
        return new AboutText.Called(texts.text(label + name), explanations, key + name);
    }
}
