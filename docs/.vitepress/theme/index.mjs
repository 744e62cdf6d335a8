import DefaultTheme from 'vitepress/theme'
import FigurePart from './FigurePart.vue'
import PlaneFigure from './PlaneFigure.vue'
import PlayPage from './PlayPage.vue'
import './style.css'

export default {
  extends: DefaultTheme,
  enhanceApp({ app }) {
    for (const [name, part] of Object.entries({ FigurePart, PlaneFigure, PlayPage })) app.component(name, part)
  },
}
