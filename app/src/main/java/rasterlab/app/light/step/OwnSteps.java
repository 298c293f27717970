package rasterlab.app.light.step;

import rasterlab.app.language.Texts;

/** The answers of a program in the order in which they are gone through: step 1 has the first. */
public sealed interface OwnSteps permits LightSteps, NormalSteps {
    /** Number of answers. */
    int count();

    /** The point of the world that an answer is about: x, y, z. */
    double[] point(int step);

    /** Says what the program answered and what is right, in the language of the lab's texts. */
    String words(int step, Texts texts);
}
