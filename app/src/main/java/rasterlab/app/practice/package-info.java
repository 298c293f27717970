/**
 * The mode "which is next?" of the labs: before each step of a method it asks for that step,
 * compares the answer with the step that the method makes, and says why.
 *
 * <p>The questions are those of the exercises of the kind 'predict it'. A lab is asked for nothing
 * but the topic; what is drawn comes from the question's JSON. Pixels are drawn with y down, planes
 * with y up. Start with {@link rasterlab.app.practice.PracticeModel}.
 */
package rasterlab.app.practice;
