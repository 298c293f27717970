package rasterlab.engine.visibility.exact;

import java.util.List;

/**
 * How a plane of faces is seen.
 *
 * @param nearness at each pixel
 * @param limits what must be at least 0 where the plane is drawn: before the eye, between the near
 *     and the far plane, on the drawn side of clip planes
 */
record PlaneSight(Nearness nearness, List<PixelSign> limits) {}
