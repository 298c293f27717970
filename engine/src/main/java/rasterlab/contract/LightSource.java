package rasterlab.contract;

/**
 * The light that a lamp sends out, wherever it stands; three shares each, of red, green and blue, 0
 * to 1000.
 *
 * @param ambient what it adds to the light that comes from everywhere
 * @param diffuse what surfaces scatter
 * @param specular what surfaces mirror
 * @param attenuation of all three with the distance
 * @param cone of all three
 */
public record LightSource(
        double[] ambient,
        double[] diffuse,
        double[] specular,
        Attenuation attenuation,
        SpotCone cone) {
    /** The highest share. */
    public static final double BRIGHTEST = 1000;

    public LightSource {
        ambient = Numbers.shares("ambient", ambient, BRIGHTEST);
        diffuse = Numbers.shares("diffuse", diffuse, BRIGHTEST);
        specular = Numbers.shares("specular", specular, BRIGHTEST);
    }

    /** White diffuse and specular light without attenuation or cone. */
    public static LightSource white() {
        double[] white = {1, 1, 1};
        return new LightSource(new double[3], white, white, Attenuation.none(), SpotCone.none());
    }

    /** This light with another attenuation. */
    public LightSource attenuated(Attenuation other) {
        return new LightSource(ambient, diffuse, specular, other, cone);
    }

    /** This light through a cone. */
    public LightSource through(SpotCone other) {
        return new LightSource(ambient, diffuse, specular, attenuation, other);
    }
}
