package rasterlab.app.opengl.state;

/**
 * A light as OpenGL is told of it, in eye space turned with the eye but not with the scene.
 *
 * @param ambient shares of red, green and blue, as diffuse and specular
 * @param position x, y, z, w: a place where w is 1, a direction where it is 0; from the scene's
 *     middle
 * @param spotDirection away from the light
 * @param cutoff half the cone's opening in degrees, or 180
 * @param attenuation constant, linear, quadratic
 */
public record GlLight(
        double[] ambient,
        double[] diffuse,
        double[] specular,
        double[] position,
        double[] spotDirection,
        double cutoff,
        double exponent,
        double[] attenuation) {
    public boolean directional() {
        return position[3] == 0;
    }
}
