package rasterlab.app.canvas.lab;

import com.formdev.flatlaf.util.UIScale;

/** Whether type is so large, for a projector or by choice, that labs stand things below others. */
public final class LargeType {
    private static final float LEAST = 1.25f;

    private LargeType() {}

    /** Whether components that are made now have large type. On the event thread. */
    public static boolean now() {
        return UIScale.getUserScaleFactor() >= LEAST;
    }
}
