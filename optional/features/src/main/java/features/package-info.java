/** Steps of Cucumber: the boards that a feature has, what happens to them and their agents, and what is seen then. */
package features;
