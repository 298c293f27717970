package rasterlab.engine.visibility;

import java.util.OptionalDouble;

/**
 * A walk with a depth for each pixel, which can be asked between two steps. Depths are as the
 * method stores them: whole numbers, nearness or a share of the range.
 */
public interface BufferedWalk extends VisibilityWalk {
    /** The content of a pixel of the picture; empty before any face was seen there. */
    OptionalDouble held(int x, int y);

    /** The depth of the last step's face there; empty where the face does not own the pixel. */
    OptionalDouble offered(int x, int y);

    /** Whether the larger of two stored depths is the nearer one. */
    boolean largerIsNearer();
}
