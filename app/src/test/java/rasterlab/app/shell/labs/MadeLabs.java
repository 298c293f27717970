package rasterlab.app.shell.labs;

import rasterlab.app.clip.ClipLabModel;
import rasterlab.app.clip.ClipRoom;
import rasterlab.app.coordinates.CoordinatesLabModel;
import rasterlab.app.coordinates.CoordinatesRoom;
import rasterlab.app.light.LightLabModel;
import rasterlab.app.light.panel.LightRoom;
import rasterlab.app.line.LineLabModel;
import rasterlab.app.line.LineRoom;
import rasterlab.app.opengl.OpenGlLabModel;
import rasterlab.app.opengl.OpenGlRoom;
import rasterlab.app.polygon.PolygonLabModel;
import rasterlab.app.polygon.PolygonRoom;
import rasterlab.app.spline.SplineLabModel;
import rasterlab.app.spline.SplineRoom;
import rasterlab.app.visibility.VisibilityLabModel;
import rasterlab.app.visibility.VisibilityRoom;

/** The models of the labs by their names, for tests that look at many of them. */
public final class MadeLabs {
    private MadeLabs() {}

    public static CoordinatesLabModel coordinates(LabModels models) {
        return models.of(new CoordinatesRoom());
    }

    public static LineLabModel line(LabModels models) {
        return models.of(new LineRoom());
    }

    public static PolygonLabModel polygon(LabModels models) {
        return models.of(new PolygonRoom());
    }

    public static ClipLabModel clip(LabModels models) {
        return models.of(new ClipRoom());
    }

    public static VisibilityLabModel visibility(LabModels models) {
        return models.of(new VisibilityRoom());
    }

    public static LightLabModel light(LabModels models) {
        return models.of(new LightRoom());
    }

    public static SplineLabModel spline(LabModels models) {
        return models.of(new SplineRoom());
    }

    public static OpenGlLabModel opengl(LabModels models) {
        return models.of(new OpenGlRoom());
    }
}
