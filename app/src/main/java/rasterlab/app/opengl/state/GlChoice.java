package rasterlab.app.opengl.state;

import java.nio.file.Path;
import java.util.Collections;
import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import rasterlab.engine.texture.Texture;

/**
 * The user's choice, which undo brings back.
 *
 * @param options one option of every setting
 * @param turn of the scene about its vertical axis, degrees in [0, 360)
 * @param tilt of the scene towards the eye, degrees from −90 to 90
 * @param distance of the eye from the scene's middle, {@value #NEAREST} to {@value #FARTHEST}
 * @param file the image that is the texture where IMAGE is {@code file}
 */
public record GlChoice(
        Map<Setting, String> options,
        double turn,
        double tilt,
        double distance,
        Optional<ImageTexture> file) {
    public static final double NEAREST = 3.8;
    public static final double FARTHEST = 16;

    /**
     * An image of the user.
     *
     * @param file where it came from, an absolute path
     */
    public record ImageTexture(Path file, Texture texture) {
        /** The name of the image: its file without the folder. */
        public String name() {
            return String.valueOf(file.getFileName());
        }
    }

    public GlChoice {
        if (!(distance >= NEAREST && distance <= FARTHEST))
            throw new IllegalArgumentException(
                    "distance must be from %s to %s, got %s"
                            .formatted(NEAREST, FARTHEST, distance));
        if (!(tilt >= -90 && tilt <= 90))
            throw new IllegalArgumentException("tilt must be from −90 to 90, got " + tilt);
        if (!(turn >= 0 && turn < 360))
            throw new IllegalArgumentException("turn must be in [0, 360), got " + turn);
        var all = new EnumMap<Setting, String>(Setting.class);
        for (Setting each : Setting.values()) all.put(each, checked(each, options.get(each)));
        if (all.get(Setting.IMAGE).equals("file") && file.isEmpty())
            throw new IllegalArgumentException("image 'file' needs a file");
        options = Collections.unmodifiableMap(all);
    }

    private static String checked(Setting setting, String option) {
        if (option == null || !setting.options().contains(option))
            throw new IllegalArgumentException(
                    "%s must be one of %s, got '%s'"
                            .formatted(
                                    setting.code(), String.join(", ", setting.options()), option));
        return option;
    }

    /** The choice that the lab opens with: the wire sphere with the hollow cylinder. */
    public static GlChoice first() {
        var options = new EnumMap<Setting, String>(Setting.class);
        for (Setting each : Setting.values()) options.put(each, each.options().get(0));
        return new GlChoice(options, 33, 25, 5.5, Optional.empty());
    }

    public String get(Setting setting) {
        return options.get(setting);
    }

    public boolean is(Setting setting, String option) {
        return options.get(setting).equals(option);
    }

    /** The number that a setting is. */
    public double number(Setting setting) {
        return Double.parseDouble(options.get(setting));
    }

    /** The parts of a setting that are written with colons between them. */
    public String[] parts(Setting setting) {
        return options.get(setting).split(":");
    }

    /** The name of OpenGL that a setting is. */
    public GlName named(Setting setting) {
        return GlName.valueOf(options.get(setting));
    }

    /** This state with another option; a scene comes with a material and a texture, or without. */
    public GlChoice with(Setting setting, String option) {
        var next = new EnumMap<>(options);
        next.put(setting, option);
        if (setting == Setting.SCENE) {
            boolean bare = option.equals("sphere");
            next.put(Setting.TEXTURE_2D, bare ? "off" : "on");
            next.put(Setting.FRONT_MATERIAL, bare ? "brass" : "chalk");
        }
        return new GlChoice(next, turn, tilt, distance, file);
    }

    /** This state with an image as its texture, switched on. */
    public GlChoice withFile(ImageTexture image) {
        var next = new EnumMap<>(options);
        next.put(Setting.IMAGE, "file");
        next.put(Setting.TEXTURE_2D, "on");
        return new GlChoice(next, turn, tilt, distance, Optional.of(image));
    }

    /**
     * This state with an image that was opened before, and all else as it is.
     *
     * @param shown whether it is the texture
     */
    public GlChoice withFile(ImageTexture image, boolean shown) {
        var next = new EnumMap<>(options);
        if (shown) next.put(Setting.IMAGE, "file");
        return new GlChoice(next, turn, tilt, distance, Optional.of(image));
    }

    /** This state with the lab's first image where a file is the texture. */
    public GlChoice withoutFile() {
        var next = new EnumMap<>(options);
        if (is(Setting.IMAGE, "file")) next.put(Setting.IMAGE, Setting.IMAGE.options().get(0));
        return new GlChoice(next, turn, tilt, distance, Optional.empty());
    }

    /** The choice turned by degrees; the tilt stops at straight up and down. */
    public GlChoice turned(double right, double down) {
        double around = turn + right - 360 * Math.floor((turn + right) / 360);
        double over = Math.max(-90, Math.min(90, tilt + down));
        return new GlChoice(options, around < 360 ? around : 0, over, distance, file);
    }

    /** The eye farther away by a factor, within the range. */
    public GlChoice dollied(double factor) {
        double next = Math.max(NEAREST, Math.min(FARTHEST, distance * factor));
        return new GlChoice(options, turn, tilt, next, file);
    }
}
