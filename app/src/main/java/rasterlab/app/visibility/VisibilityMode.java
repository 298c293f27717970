package rasterlab.app.visibility;

import java.util.ArrayList;
import java.util.List;

/** Which of the tab's labs is shown: scenes, or rows of depths. */
final class VisibilityMode {
    static final String SCENE = "scene";

    private VisibilityMode() {}

    /** Scenes, and the topics whose rows can be shown. */
    static List<String> names(VisibilityLabModel model) {
        var names = new ArrayList<String>(List.of(SCENE));
        names.addAll(model.rows().topics());
        return names;
    }

    static void choose(VisibilityLabModel model, String name) {
        if (name.equals(SCENE)) model.rows().close();
        else model.rows().open(name);
    }
}
