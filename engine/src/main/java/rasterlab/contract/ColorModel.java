package rasterlab.contract;

/**
 * A way of writing down a colour as three or four numbers.
 *
 * <p>Shares run from 0 to 1, hues from 0 (red) over 120 (green) and 240 (blue) up to 360 degrees. A
 * grey has no hue: it is written as NaN.
 */
public enum ColorModel {
    /** Shares of red, green and blue light. */
    RGB("rgb", "red", "green", "blue"),
    /** The inks that are taken from white: 1 − red, 1 − green, 1 − blue. */
    CMY("cmy", "cyan", "magenta", "yellow"),
    /** Inks with black: as much black as possible, the others in shares of what black leaves. */
    CMYK("cmyk", "cyan", "magenta", "yellow", "black"),
    /** The hexagonal cone: value = the largest of r, g, b; saturation = 1 − smallest/largest. */
    HSV("hsv", "hue", "saturation", "value"),
    /**
     * Hue, value and saturation in the colour cube: value (0 to √3) is the distance along the grey
     * diagonal from black, saturation (0 to √(2/3)) the distance from it, hue the angle about it.
     */
    HVS("hvs", "hue", "value", "saturation");

    private final String code;
    private final String[] components;

    ColorModel(String code, String... components) {
        this.code = code;
        this.components = components;
    }

    /** Lower-case name. */
    public String code() {
        return code;
    }

    /** How many numbers a colour has. */
    public int size() {
        return components.length;
    }

    /** The name of the number at {@code index}. */
    public String component(int index) {
        return components[index];
    }

    /** Whether the number at {@code index} is an angle in degrees. */
    public boolean isHue(int index) {
        return index == 0 && (this == HSV || this == HVS);
    }

    /** The highest number at {@code index}; the lowest is 0. */
    public double highest(int index) {
        if (isHue(index)) return 360;
        if (this != HVS) return 1;
        // This is the distance of the farthest corners, with what rounding may add.
        return Math.sqrt(index == 1 ? 3 : 2 / 3.0) * (1 + 0x1p-50);
    }

    /** The index of the saturation, or −1. */
    public int saturation() {
        return this == HSV ? 1 : this == HVS ? 2 : -1;
    }
}
